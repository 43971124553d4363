// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh.h"

#include <algorithm>
#include <cmath>

namespace toss::simulation {
namespace {

using Eigen::Vector3d;

/// Two directions at right angles to `axis` and to each other.
std::array<Vector3d, 2> crossSection(const Vector3d& axis) {
  const Vector3d helper =
      std::abs(axis.z()) < 0.9 * axis.norm() ? Vector3d::UnitZ() : Vector3d::UnitX();
  const Vector3d first = axis.cross(helper).normalized();
  return {first, axis.cross(first).normalized()};
}

}  // namespace

std::uint32_t Mesh::addVertex(const Vector3d& vertex) {
  vertices.push_back(vertex.cast<float>());
  return static_cast<std::uint32_t>(vertices.size() - 1);
}

void Mesh::addTriangle(const Vector3d& a, const Vector3d& b, const Vector3d& c, Surface surface) {
  const std::uint32_t first = addVertex(a);
  addVertex(b);
  addVertex(c);
  triangles.push_back({first, first + 1, first + 2});
  surfaces.push_back(surface);
}

void Mesh::addQuad(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d,
                   Surface surface) {
  const std::uint32_t first = addVertex(a);
  addVertex(b);
  addVertex(c);
  addVertex(d);
  triangles.push_back({first, first + 1, first + 2});
  triangles.push_back({first, first + 2, first + 3});
  surfaces.insert(surfaces.end(), 2, surface);
}

void Mesh::addBox(const Vector3d& center, const Vector3d& size, Surface surface) {
  const Vector3d half = 0.5 * size;
  const auto corner = [&](int i) -> Vector3d {
    return center + Vector3d(i & 1 ? half.x() : -half.x(), i & 2 ? half.y() : -half.y(),
                             i & 4 ? half.z() : -half.z());
  };
  static constexpr int kFaces[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                       {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
  for (const auto& face : kFaces) {
    addQuad(corner(face[0]), corner(face[1]), corner(face[2]), corner(face[3]), surface);
  }
}

void Mesh::addBar(const Vector3d& from, const Vector3d& to, double radiusFrom, double radiusTo,
                  Surface surface, int sides) {
  const auto [first, second] = crossSection(to - from);
  const auto rim = [&, u = first, v = second](int i) -> Vector3d {
    const double angle = 2.0 * M_PI * i / sides;
    return std::cos(angle) * u + std::sin(angle) * v;
  };
  for (int i = 0; i < sides; ++i) {
    const Vector3d a = rim(i), b = rim(i + 1);
    addQuad(from + radiusFrom * a, from + radiusFrom * b, to + radiusTo * b, to + radiusTo * a,
            surface);
    addTriangle(from, from + radiusFrom * a, from + radiusFrom * b, surface);
    addTriangle(to, to + radiusTo * a, to + radiusTo * b, surface);
  }
}

void Mesh::addEllipsoid(const Vector3d& center, const Vector3d& radii, Surface surface) {
  constexpr int kAround = 8, kUp = 5;
  const auto point = [&](int around, int up) -> Vector3d {
    const double a = 2.0 * M_PI * around / kAround,
                 b = M_PI * (static_cast<double>(up) / kUp - 0.5);
    const Vector3d direction(std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b));
    return center + radii.cwiseProduct(direction);
  };
  for (int up = 0; up < kUp; ++up) {
    for (int around = 0; around < kAround; ++around) {
      addQuad(point(around, up), point(around + 1, up), point(around + 1, up + 1),
              point(around, up + 1), surface);
    }
  }
}

void Mesh::append(const Mesh& other, const Eigen::Isometry3d& pose) {
  const auto offset = static_cast<std::uint32_t>(vertices.size());
  for (const Eigen::Vector3f& vertex : other.vertices) addVertex(pose * vertex.cast<double>());
  for (const auto& t : other.triangles) {
    triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  }
  surfaces.insert(surfaces.end(), other.surfaces.begin(), other.surfaces.end());
}

Eigen::AlignedBox3d Mesh::bounds() const {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3f& vertex : vertices) box.extend(vertex.cast<double>());
  return box;
}

Mesh gridMesh(const std::vector<double>& us, const std::vector<double>& vs,
              const std::function<Vector3d(double, double)>& point,
              const std::function<Surface(double, double)>& surface) {
  Mesh mesh;
  for (double u : us) {
    for (double v : vs) mesh.addVertex(point(u, v));
  }
  const auto stride = static_cast<std::uint32_t>(vs.size());
  for (std::uint32_t i = 0; i + 1 < us.size(); ++i) {
    for (std::uint32_t j = 0; j + 1 < stride; ++j) {
      const std::uint32_t corner = i * stride + j;
      mesh.triangles.push_back({corner, corner + stride, corner + stride + 1});
      mesh.triangles.push_back({corner, corner + stride + 1, corner + 1});
      mesh.surfaces.insert(mesh.surfaces.end(), 2,
                           surface(0.5 * (us[i] + us[i + 1]), 0.5 * (vs[j] + vs[j + 1])));
    }
  }
  return mesh;
}

std::vector<double> gridLines(double low, double high, double step,
                              const std::vector<double>& edges) {
  constexpr double kHalfEdge = 0.01;
  std::vector<double> lines;
  const int count = std::max(1, static_cast<int>(std::ceil((high - low) / step)));
  for (int i = 0; i <= count; ++i) {
    const double line = low + (high - low) * i / count;
    const bool nearEdge = std::any_of(edges.begin(), edges.end(), [&](double edge) {
      return std::abs(edge - line) < 3.0 * kHalfEdge;
    });
    if (!nearEdge) lines.push_back(line);
  }
  for (double edge : edges) {
    lines.push_back(edge - kHalfEdge);
    lines.push_back(edge + kHalfEdge);
  }
  std::sort(lines.begin(), lines.end());
  return lines;
}

Eigen::Isometry3d planarPose(double x, double y, double z, double yaw) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translate(Vector3d(x, y, z)).rotate(Eigen::AngleAxisd(yaw, Vector3d::UnitZ()));
  return pose;
}

}  // namespace toss::simulation
