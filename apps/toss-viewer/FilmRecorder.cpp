// SPDX-License-Identifier: BSD-3-Clause
#include "FilmRecorder.h"

#include <toss/rawlog/AtomicFile.h>

#include <opencv2/videoio.hpp>

#include "FramePainter.h"
#include "Progress.h"

namespace toss {
namespace {

cv::VideoWriter openFilm(const FilmRequest& request, const std::filesystem::path& temporary) {
  cv::VideoWriter film;
  const int codec = cv::VideoWriter::fourcc('m', 'p', '4', 'v');
  if (!film.open(temporary.string(), codec, request.rate, {request.width, request.height}))
    throw UserError(request.file.string(), "can not be written as a film",
                    "check the folder, and that the name ends in .mp4");
  return film;
}

}  // namespace

void recordFilm(LivePlayer& player, const FilmRequest& request, bool quiet) {
  AtomicFile file(request.file);
  inRenderThread([&] {
    cv::VideoWriter film = openFilm(request, file.temporaryPath());
    FramePainter painter(request.width, request.height);
    Progress progress("recording", "scans", quiet);
    CameraGuide guide;
    Camera camera;
    camera.width = request.width;
    camera.height = request.height;
    LiveFrame frame;
    std::uint64_t count = 0;
    while (player.next(frame)) {
      camera = guide.next(request.camera, frame.mapFromSensor, camera);
      film.write(painter.paint(frame, LayerChoice(), camera, player.name()));
      progress.update(++count, player.progress());
    }
    film.release();
  });
  file.commit();
}

}  // namespace toss
