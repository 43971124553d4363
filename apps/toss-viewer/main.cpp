// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/Error.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "FilmRecorder.h"
#include "Interruption.h"
#include "ViewerWindow.h"
#include "WholeNumber.h"

namespace {

constexpr int kWrongInput = 1, kInternalFault = 2, kInterrupted = 130;

struct Arguments {
  toss::PlayRequest play;
  toss::WindowRequest window;
  toss::FilmRequest film;
  std::string size = "1280x720", camera = "chase";
  bool quiet = false;
};

void addOptions(CLI::App& program, Arguments& to) {
  program.add_option("INPUT", to.play.input, "Rawlog, or folder in KITTI layout")->required();
  program.add_option("--record", to.film.file, "Write a film, a .mp4, instead; needs no display");
  program.add_option("--screenshot", to.window.screenshot,
                     "Play to the end, write what the window shows there (.png), and close");
  program.add_option("--config", to.play.configuration.file, "Configuration, an .ini file");
  program.add_option("--set", to.play.configuration.settings, "section.key=value, repeatable")
      ->allow_extra_args(false);
  program.add_option("--from", to.play.from, "First scan, counted from 0")
      ->check(toss::wholeNumber());
  program.add_option("--to", to.play.to, "Last scan, included")->check(toss::wholeNumber());
  program.add_option("--camera", to.camera, "chase, top, follow or free")
      ->check(CLI::IsMember({"chase", "top", "follow", "free"}));
  program.add_option("--size", to.size, "WIDTHxHEIGHT in pixels");
  program
      .add_option("--speed", to.window.speed, "Times the speed of the log; 0 = as fast as it goes")
      ->check(CLI::Range(0.0, 16.0));
  program.add_option("--rate", to.film.rate, "Scans per second of the film")
      ->check(CLI::Range(1.0, 120.0));
  program.add_option("--map-every", to.play.mapPeriod, "Renew the map after so many scans")
      ->check(CLI::Range(1, 100000));
  program.add_flag("-q,--quiet", to.quiet, "Say nothing but errors");
}

void setSize(Arguments& arguments) {
  int width = 0, height = 0;
  char rest = 0;
  const bool two = std::sscanf(arguments.size.c_str(), "%dx%d%c", &width, &height, &rest) == 2;
  if (!two || width < 160 || height < 120 || width > 4096 || height > 4096)
    throw toss::UserError("--size " + arguments.size,
                          "this is not WIDTHxHEIGHT from 160x120 to 4096x4096",
                          "write, for instance, 1280x720");
  // Frame buffers want multiples of 4, films even numbers.
  arguments.window.width = arguments.film.width = width - width % 4;
  arguments.window.height = arguments.film.height = height - height % 2;
}

void play(Arguments arguments) {
  setSize(arguments);
  for (const toss::CameraMode mode : {toss::CameraMode::Chase, toss::CameraMode::Top,
                                      toss::CameraMode::Follow, toss::CameraMode::Free})
    if (arguments.camera == toss::nameOf(mode))
      arguments.window.camera = arguments.film.camera = mode;
  if (!arguments.film.file.empty() && !arguments.window.screenshot.empty())
    throw toss::UserError("--record", "it does not go with --screenshot", "give one of the two");
  toss::LivePlayer player(arguments.play);
  if (arguments.film.file.empty())
    toss::showWindow(player, arguments.window);
  else
    toss::recordFilm(player, arguments.film, arguments.quiet);
}

int run(int argc, char** argv) {
  CLI::App program("Watch TOSS find what moves, in a window or as a film", "toss-viewer");
  program.set_version_flag("--version", "toss-viewer " TOSS_VERSION);
  program.footer("Example: toss-viewer drive.rawlog --record drive.mp4");
  Arguments arguments;
  addOptions(program, arguments);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return program.exit(error);
    std::cerr << "toss-viewer: " << error.what() << "; see toss-viewer --help\n";
    return kWrongInput;
  }
  play(arguments);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const toss::UserError& error) {
    std::cerr << "toss-viewer: " << error.what() << "\n";
    return kWrongInput;
  } catch (const toss::Interrupted&) {
    std::cerr << "toss-viewer: interrupted; what was unfinished is cleared away\n";
    return kInterrupted;
  } catch (const std::exception& error) {
    std::cerr << "toss-viewer: internal fault: " << error.what() << "\n";
    return kInternalFault;
  }
}
