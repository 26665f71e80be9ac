// SPDX-License-Identifier: MIT
/// @file
/// The video module: MP4 by OpenCV's videoio, that is by FFmpeg.
#include "pictures/module.hpp"

#include <opencv2/core.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include <array>
#include <memory>
#include <string>

namespace raymarch::pictures
{
namespace
{

/// H.264 plays everywhere; MPEG-4 is there where FFmpeg was built without an encoder for it.
constexpr std::array<std::array<char, 4>, 2> codecs = {
    {{'a', 'v', 'c', '1'}, {'m', 'p', '4', 'v'}}};

int even(int length) noexcept
{
    return length + length % 2;
}

class Encoder final : public VideoEncoder
{
  public:
    Encoder(const char* path, int width, int height) : path_(path), width_(width), height_(height)
    {}

    bool open(unsigned frames_per_second)
    {
        for (const auto& [a, b, c, d] : codecs)
            // FFmpeg by name: what else OpenCV would try takes long and cannot do it.
            if (writer_.open(path_, cv::CAP_FFMPEG, cv::VideoWriter::fourcc(a, b, c, d),
                             frames_per_second, {even(width_), even(height_)}))
                return true;
        return false;
    }

    bool add(const std::uint8_t* rgb) override
    {
        try {
            const cv::Mat pixels(height_, width_, CV_8UC3,
                                 const_cast<std::uint8_t*>(rgb)); // only read
            cv::Mat bgr;
            cv::cvtColor(pixels, bgr, cv::COLOR_RGB2BGR);
            // Both codecs take even sizes only; OpenCV would cut the odd column and row off.
            cv::Mat whole;
            cv::copyMakeBorder(bgr, whole, 0, even(height_) - height_, 0, even(width_) - width_,
                               cv::BORDER_REPLICATE);
            writer_.write(whole);
            ++frames_;
            return true;
        } catch (const cv::Exception&) {
            return false;
        }
    }

    /// OpenCV does not say when a write failed (a full disk): the file is asked.
    bool finish() override
    {
        try {
            writer_.release();
            const cv::VideoCapture written(path_, cv::CAP_FFMPEG);
            return written.isOpened() && written.get(cv::CAP_PROP_FRAME_COUNT) == frames_;
        } catch (const cv::Exception&) {
            return false;
        }
    }

  private:
    std::string path_;
    int width_;
    int height_;
    int frames_ = 0;
    cv::VideoWriter writer_;
};

} // namespace
} // namespace raymarch::pictures

extern "C" raymarch::pictures::VideoEncoder*
raymarch_open_video(const char* path, int width, int height, unsigned frames_per_second)
{
    try {
        // What fails is said in our own words.
        cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
        auto encoder = std::make_unique<raymarch::pictures::Encoder>(path, width, height);
        return encoder->open(frames_per_second) ? encoder.release() : nullptr;
    } catch (const cv::Exception&) {
        return nullptr;
    }
}
