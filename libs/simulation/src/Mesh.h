// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "Surface.h"

namespace toss::simulation {

/// Triangles with what each of them is.
struct Mesh {
  /// [m], in the frame of the object.
  std::vector<Eigen::Vector3f> vertices;
  /// Indices into vertices, and the surface of each triangle.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Surface> surfaces;

  std::uint32_t addVertex(const Eigen::Vector3d& vertex);
  void addTriangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                   Surface surface);
  /// Corners in order around the face.
  void addQuad(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
               const Eigen::Vector3d& d, Surface surface);
  /// Upright box of full extents `size` around `center`.
  void addBox(const Eigen::Vector3d& center, const Eigen::Vector3d& size, Surface surface);
  /// Round bar from one point to another, with its ends closed.
  void addBar(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radiusFrom,
              double radiusTo, Surface surface, int sides = 8);
  /// Ellipsoid of half-axes `radii`.
  void addEllipsoid(const Eigen::Vector3d& center, const Eigen::Vector3d& radii, Surface surface);
  /// Everything of `other`, moved by `pose`.
  void append(const Mesh& other, const Eigen::Isometry3d& pose);

  Eigen::AlignedBox3d bounds() const;
};

/// Surface over a grid of parameters: `point(u, v)` gives its vertices, `surface(u, v)` what the
/// cell with that middle is. Lines that lie close together make edges, e.g. kerbs.
Mesh gridMesh(const std::vector<double>& us, const std::vector<double>& vs,
              const std::function<Eigen::Vector3d(double, double)>& point,
              const std::function<Surface(double, double)>& surface);

/// Ascending values from `low` to `high` at most `step` apart, with a pair of lines 2 cm apart
/// around every one of `edges`.
std::vector<double> gridLines(double low, double high, double step,
                              const std::vector<double>& edges = {});

/// Rotation about z by `yaw` [rad] and translation.
Eigen::Isometry3d planarPose(double x, double y, double z, double yaw);

}  // namespace toss::simulation
