// SPDX-License-Identifier: BSD-3-Clause
#include <toss/evaluation/EvaluationReport.h>

#include <cmath>
#include <cstdarg>
#include <cstdio>

namespace toss {
namespace {

/// Text that grows line by line.
class Lines {
 public:
  __attribute__((format(printf, 2, 3))) void add(const char* format, ...) {
    char line[512];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(line, sizeof line, format, arguments);
    va_end(arguments);
    text_ += line;
    text_ += '\n';
  }
  void addText(const std::string& line) { text_ += line + '\n'; }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// A number in a column of `width`, "-" where it is undefined.
std::string cell(double value, int decimals, int width = 9) {
  char text[64];
  if (!std::isfinite(value)) {
    std::snprintf(text, sizeof text, "%*s", width, "-");
  } else {
    std::snprintf(text, sizeof text, "%*.*f", width, decimals, value);
  }
  return text;
}

std::string cells(const PreservationRejection& r) {
  return cell(r.preservationRate(), 3) + cell(r.rejectionRate(), 3) + cell(r.f1(), 4);
}

void addMap(const char* name, const std::optional<MapReport>& map, Lines& lines) {
  if (!map) return;
  std::string row = cells(map->rates);
  if (map->removal) {
    const RemovalAccuracy& r = *map->removal;
    row += cell(r.staticAccuracy(), 3) + cell(r.dynamicAccuracy(), 3) +
           cell(r.associatedAccuracy(), 3) + cell(r.harmonicAccuracy(), 3);
  }
  lines.add("  %-14s%s", name, row.c_str());
}

void addMaps(const EvaluationReport& report, Lines& lines) {
  if (!report.labels && !report.map) return;
  lines.add("Static map       PR [%%]   RR [%%]       F1   SA [%%]   DA [%%]   AA [%%]   HA [%%]");
  addMap("labels", report.labels, lines);
  addMap("live labels", report.liveLabels, lines);
  addMap("map file", report.map, lines);
}

void addMoving(const char* name, const std::optional<MovingScores>& scores, Lines& lines) {
  if (!scores) return;
  const auto row = [&](const char* what, const MovingCounts& c) {
    lines.add("  %-14s%s%s%s", what, cell(c.intersectionOverUnion(), 4).c_str(),
              cell(c.precision(), 4).c_str(), cell(c.recall(), 4).c_str());
  };
  lines.add("%-19s IoU precision   recall", name);
  row("all", scores->all);
  for (int b = 0; b < kRangeBands; ++b) {
    row(rangeBandName(b), scores->byRange[static_cast<std::size_t>(b)]);
  }
  for (const auto& [trueClass, counts] : scores->byClass) {
    lines.add("  class %-8u%12llu points, %llu called moving", trueClass,
              static_cast<unsigned long long>(counts.points),
              static_cast<unsigned long long>(counts.calledMoving));
  }
}

void addTracking(const char* name, const std::optional<TrackingReport>& tracking, Lines& lines) {
  if (!tracking) return;
  const ClearMot& c = tracking->clear;
  lines.add("%-14s MOTA%s  MOTP%s  AMOTA%s  sAMOTA%s", name, cell(c.accuracy(), 3, 7).c_str(),
            cell(c.precision(), 3, 7).c_str(), cell(tracking->averaged.amota, 3, 7).c_str(),
            cell(tracking->averaged.samota, 3, 7).c_str());
  lines.add("  %llu identity switches, %llu fragmentations, %llu of %llu objects mostly tracked",
            static_cast<unsigned long long>(c.identitySwitches),
            static_cast<unsigned long long>(c.fragmentations),
            static_cast<unsigned long long>(c.mostlyTracked),
            static_cast<unsigned long long>(c.trajectories));
}

void addResidue(const char* name, const LossTable& losses, std::uint64_t movingVoxels,
                Lines& lines) {
  if (movingVoxels == 0) return;
  lines.add("%s, share of moving voxels left by cause [%%]", name);
  for (int c = 0; c < kLossCauses; ++c) {
    const auto count = losses.residueByCause.at(static_cast<std::size_t>(c));
    if (count == 0) continue;
    lines.add(
        "  %-42s%s", lossCauseName(static_cast<LossCause>(c)),
        cell(100.0 * static_cast<double>(count) / static_cast<double>(movingVoxels), 2).c_str());
  }
}

void addBounds(const EvaluationReport& report, Lines& lines) {
  if (report.bounds.empty()) return;
  lines.add("Bounds                                                PR [%%]   RR [%%]       F1");
  for (const BoundReport& bound : report.bounds) {
    lines.add("  %-49s%s", bound.name.c_str(), cells(bound.rates).c_str());
  }
}

void addStages(const EvaluationReport& report, Lines& lines) {
  if (report.stages.empty()) return;
  lines.add("Stage [ms]          mean   median      p95      max");
  for (const StageTime& s : report.stages) {
    lines.add("  %-13s%s%s%s%s", s.stage.c_str(), cell(s.mean, 2).c_str(),
              cell(s.median, 2).c_str(), cell(s.percentile95, 2).c_str(),
              cell(s.largest, 2).c_str());
  }
}

void addResources(const EvaluationReport& report, Lines& lines) {
  if (report.peakMemoryBytes <= 0.0) return;
  constexpr double kMegabyte = 1e6;
  lines.add("The run took %.1f s (%.1f scans/s), %.1f s of processor time, at most %.0f MB",
            report.wallSeconds, report.scansPerSecond, report.processorSeconds,
            report.peakMemoryBytes / kMegabyte);
  lines.add("  %s threads of %s", report.threads.c_str(), report.processor.c_str());
}

}  // namespace

std::string toText(const EvaluationReport& report) {
  Lines lines;
  lines.add("%llu scans, %llu points, voxels of %g m, points without a true label %s",
            static_cast<unsigned long long>(report.scans),
            static_cast<unsigned long long>(report.points), report.voxelSize,
            report.unlabelledIgnored ? "left out" : "count as static");
  addMaps(report, lines);
  addMoving("Moving points", report.moving, lines);
  addMoving("Moving points, live", report.liveMoving, lines);
  addTracking("Tracks", report.tracking, lines);
  addTracking("Boxes", report.boxTracking, lines);
  if (report.labels) {
    addResidue("Labels", report.labels->losses, report.labels->rates.movingVoxels, lines);
  }
  addBounds(report, lines);
  addStages(report, lines);
  addResources(report, lines);
  for (const std::string& warning : report.warnings) lines.addText("Warning: " + warning);
  return lines.text();
}

}  // namespace toss
