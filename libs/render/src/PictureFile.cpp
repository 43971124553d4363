// SPDX-License-Identifier: BSD-3-Clause
#include "PictureFile.h"

#include <toss/geometry/Error.h>
#include <toss/rawlog/AtomicFile.h>

#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <vector>

namespace toss {

void writePicture(const std::filesystem::path& file, const cv::Mat& picture) {
  // Encoded in memory: imwrite() does not tell of a full disk.
  std::vector<unsigned char> bytes;
  if (!cv::imencode(".png", picture, bytes))
    throw UserError(file.string(), "can not be encoded as PNG", "install OpenCV with PNG support");
  writeAtomically(file, [&](const std::filesystem::path& temporary) {
    std::ofstream out(temporary, std::ios::binary);
    out.write(reinterpret_cast<const char*>(bytes.data()),
              static_cast<std::streamsize>(bytes.size()));
    out.close();
    if (!out)
      throw UserError(file.string(), "can not be written",
                      "make room there, or choose another folder to write to");
  });
}

}  // namespace toss
