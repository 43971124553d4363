// SPDX-License-Identifier: BSD-3-Clause
#include "AssociationSection.h"

#include <limits>
#include <string>

#include "ResultSummary.h"

namespace toss {
namespace {

std::string inMilliseconds(double time) {
  return numberText(time, time < 1.0 ? 4 : 2);
}

void writeTimes(std::ostream& out, const std::vector<AssociationCurve>& curves) {
  out << "| traces |";
  std::string rule = "\n|---|";
  for (const AssociationCurve& curve : curves) out << " " << curve.method << " |", rule += "---|";
  out << rule << "\n";
  for (const int size : curves.front().sizes) {
    out << "| " << size << " |";
    for (const AssociationCurve& curve : curves)
      out << " " << inMilliseconds(curve.at(size)) << " |";
    out << "\n";
  }
  out << "| exponent |";
  for (const AssociationCurve& curve : curves) out << " " << numberText(curve.exponent, 2) << " |";
  out << "\n\n![Association time by number of traces](association.png)\n\n";
}

void writeSpeedUp(std::ostream& out, const AssociationCurve& fast, const AssociationCurve& slow) {
  for (const int size : kSpeedUpSizes)
    out << "- At " << size << " traces hierarchical association is "
        << numberText(slow.at(size) / fast.at(size), 1) << " times as fast as exhaustive.\n";
}

void writeAgreement(std::ostream& out, const AssociationAgreement& agreement) {
  out << "- At " << agreement.density << " traces per square metre it chooses "
      << numberText(
             100.0 * static_cast<double>(agreement.equal) / static_cast<double>(agreement.pairs), 3)
      << " % of the exhaustive method's " << agreement.pairs << " pairs.\n";
}

double trackingTime(const RunScores& scores) {
  for (const auto& [stage, time] : scores.stageMedians)
    if (stage == "tracking") return time;
  return std::numeric_limits<double>::quiet_NaN();
}

void writeScenes(std::ostream& out, const std::vector<CaseResult>& results) {
  std::string rows;
  for (const std::string& scene : scenesWorstFirst(results)) {
    const CaseResult* usual = firstResult(results, scene, kDefaultName);
    const CaseResult* full = firstResult(results, scene, kExhaustiveName);
    if (usual == nullptr || full == nullptr) continue;
    rows += "| " + scene + " | " + std::to_string(usual->scans) + " | " +
            numberText(trackingTime(usual->scores), 3) + " | " +
            numberText(trackingTime(full->scores), 3) + " | " +
            numberText(usual->scores.map.f1(), 4) + " | " + numberText(full->scores.map.f1(), 4) +
            " |\n";
  }
  if (rows.empty()) return;
  out << "\nThe whole of tracking in runs on scenes (seed 1), median per scan [ms], with either "
         "association.\n\n| scene | scans | hierarchical | exhaustive | F1, hierarchical | F1, "
         "exhaustive |\n|---|---|---|---|---|---|\n"
      << rows;
}

}  // namespace

void writeAssociation(std::ostream& out, const AssociationStudy& study,
                      const std::vector<CaseResult>& results) {
  out << "\n## Association time\n\nThe paper's Table 2. Median time [ms] to associate one scan's "
         "boxes with the traces, random boxes of people and cars, "
      << kStudyDensity
      << " traces per square metre, one thread; the exponent is that of the growth over the last "
         "five doublings.\n\n";
  writeTimes(out, study.curves);
  writeSpeedUp(out, study.curves[0], study.curves[1]);
  for (const AssociationAgreement& agreement : study.agreements) writeAgreement(out, agreement);
  writeScenes(out, results);
}

}  // namespace toss
