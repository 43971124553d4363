// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "CameraMode.h"
#include "LivePlayer.h"

namespace toss {

/// How a film is made.
struct FilmRequest {
  /// The film, a .mp4.
  std::filesystem::path file;
  CameraMode camera = CameraMode::Chase;
  /// Size of the picture [px]; width a multiple of 4, height even.
  int width = 1280, height = 720;
  /// Scans per second of the film.
  double rate = 10.0;
};

/// Plays everything and writes it as a film; needs no display. Throws UserError where the film can
/// not be written, RenderUnavailable where drawing is impossible.
void recordFilm(LivePlayer& player, const FilmRequest& request, bool quiet);

}  // namespace toss
