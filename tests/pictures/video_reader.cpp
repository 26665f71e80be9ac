// SPDX-License-Identifier: MIT
#include "tests/pictures/video_reader.hpp"

#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

extern "C" double raymarch_read_video(const char* path, raymarch::test::FrameSink sink,
                                      void* context)
{
    cv::VideoCapture video(path, cv::CAP_FFMPEG);
    for (cv::Mat bgr; video.read(bgr);) {
        cv::Mat rgb;
        cv::cvtColor(bgr, rgb, cv::COLOR_BGR2RGB);
        sink(context, rgb.data, rgb.cols, rgb.rows);
    }
    return video.get(cv::CAP_PROP_FPS);
}
