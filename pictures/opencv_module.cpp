// SPDX-License-Identifier: MIT
/// @file
/// The OpenCV module: JPEG.
#include "pictures/module.hpp"

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <vector>

extern "C" bool raymarch_encode_picture(const char* extension, const std::uint8_t* rgb, int width,
                                        int height, raymarch::pictures::ByteSink sink,
                                        void* context)
{
    try {
        const cv::Mat pixels(height, width, CV_8UC3, const_cast<std::uint8_t*>(rgb)); // only read
        cv::Mat bgr;
        cv::cvtColor(pixels, bgr, cv::COLOR_RGB2BGR);
        std::vector<std::uint8_t> bytes;
        if (!cv::imencode(extension, bgr, bytes))
            return false;
        sink(context, bytes.data(), bytes.size());
        return true;
    } catch (const cv::Exception&) {
        return false;
    }
}
