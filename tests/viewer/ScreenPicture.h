// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <opencv2/core.hpp>
#include <string>
#include <thread>

#include "InputFixtures.h"

namespace toss::test {

/// A program that runs beside the test and ends with it.
class BackgroundProgram {
 public:
  explicit BackgroundProgram(const std::string& command) : process_(::fork()) {
    if (process_ == 0) {
      ::setpgid(0, 0);
      const std::string quiet = "exec env " + command + " >/dev/null 2>&1";
      ::execl("/bin/sh", "sh", "-c", quiet.c_str(), nullptr);
      ::_exit(127);
    }
  }
  ~BackgroundProgram() {
    if (ended_) return;
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
  }
  BackgroundProgram(const BackgroundProgram&) = delete;
  BackgroundProgram& operator=(const BackgroundProgram&) = delete;
  bool isRunning() {
    if (!ended_) ended_ = ::waitpid(process_, nullptr, WNOHANG) != 0;
    return !ended_;
  }

 private:
  pid_t process_;
  bool ended_ = false;
};

/// An X server that draws into a file.
class VirtualDisplay {
 public:
  explicit VirtualDisplay(const fs::path& folder)
      : folder_(folder),
        number_(std::to_string(nextNumber())),
        server_((fs::create_directories(folder),
                 "Xvfb :" + number_ + " -screen 0 1400x900x24 -fbdir '" + folder.string() + "'")) {
    for (int attempt = 0; attempt < 600 && !fs::exists("/tmp/.X11-unix/X" + number_); ++attempt)
      pause();
  }
  std::string environment() const { return "env DISPLAY=:" + number_ + " "; }

  /// What the screen shows, BGR; all black if it can't be read.
  cv::Mat picture() const {
    pause();
    const std::string bytes = readBytes(folder_ / "Xvfb_screen0");
    cv::Mat result = cv::Mat::zeros(900, 1400, CV_8UC3);
    // An XWD file: a header of big-endian numbers, colours, and rows of BGRX.
    const std::size_t start = numberAt(bytes, 0) + 12 * numberAt(bytes, 19);
    const std::size_t stride = numberAt(bytes, 12);
    if (bytes.size() < start + 900 * stride || stride < 1400 * 4) return result;
    for (int row = 0; row < 900; ++row)
      for (int column = 0; column < 1400; ++column)
        std::memcpy(result.at<cv::Vec3b>(row, column).val,
                    bytes.data() + start + static_cast<std::size_t>(row) * stride +
                        static_cast<std::size_t>(column) * 4,
                    3);
    return result;
  }

 private:
  /// Another one for each display of a program: the socket of the one before may still be there
  /// while its server ends.
  static int nextNumber() {
    static int displays = 0;
    return 100 + 2 * (::getpid() % 15000) + displays++ % 2;
  }
  static void pause() { std::this_thread::sleep_for(std::chrono::milliseconds(100)); }
  static std::size_t numberAt(const std::string& bytes, std::size_t index) {
    std::size_t value = 0;
    for (std::size_t i = 4 * index; i < 4 * index + 4 && i < bytes.size(); ++i)
      value = value * 256 + static_cast<unsigned char>(bytes[i]);
    return value;
  }

  fs::path folder_;
  std::string number_;
  BackgroundProgram server_;
};

}  // namespace toss::test
