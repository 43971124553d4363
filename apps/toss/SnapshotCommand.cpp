// SPDX-License-Identifier: BSD-3-Clause
#include <toss/render/MapContent.h>
#include <toss/render/Snapshots.h>

#include <map>
#include <memory>

#include "Command.h"

namespace toss {
namespace {

struct SnapshotRequest {
  std::vector<std::filesystem::path> inputs;
  std::filesystem::path output;
  View view = View::Top;
  std::string size = "1920x1080";
  PictureColor color = PictureColor::Height;
};

void setSize(const std::string& size, RenderOptions& options) {
  char rest = 0;
  if (std::sscanf(size.c_str(), "%dx%d%c", &options.width, &options.height, &rest) != 2)
    throw UserError("--size " + size, "this is not WIDTHxHEIGHT", "write, for instance, 1920x1080");
  options.check();
}

void snapshot(const SnapshotRequest& request) {
  RenderOptions options;
  options.color = request.color;
  setSize(request.size, options);
  const MapContent content =
      readMapContent(request.inputs, static_cast<std::size_t>(options.maxPoints));
  renderPicture(content, request.view, request.output, options);
}

}  // namespace

void addSnapshotCommand(CLI::App& program, const Verbosity&) {
  auto request = std::make_shared<SnapshotRequest>();
  const std::map<std::string, View> views = {
      {"top", View::Top}, {"chase", View::Chase}, {"corner", View::Corner}};
  const std::map<std::string, PictureColor> colors = {{"height", PictureColor::Height},
                                                      {"intensity", PictureColor::Intensity},
                                                      {"class", PictureColor::Class}};
  CLI::App* command = program.add_subcommand("snapshot", "Draw a picture of a map or of a run");
  command->footer("Example: toss snapshot result --out map.png --view corner --color class");
  command->add_option("INPUT", request->inputs, "Point files (PLY, PCD) or folders of toss map")
      ->required();
  command->add_option("--out", request->output, "The picture, a .png")->required();
  command->add_option("--view", request->view, "top, chase or corner")
      ->transform(CLI::CheckedTransformer(views));
  command->add_option("--size", request->size, "WIDTHxHEIGHT in pixels");
  command->add_option("--color", request->color, "height, intensity or class")
      ->transform(CLI::CheckedTransformer(colors));
  command->callback([request] { snapshot(*request); });
}

}  // namespace toss
