// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/PrincipalAxes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <glm/geometric.hpp>

namespace core::mesh {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

constexpr int kSweeps = 12;  ///< three would do: the error falls with its square

/// Returns the covariance of the points of the surface; zero without an area. Exact for each triangle: the integral of
/// x y over a triangle of area A is A / 12 (sum of x_i y_i over its corners + 9 times the product of its centroid).
Matrix covarianceOf(const TriangleMesh& mesh)
{
    Matrix m{};
    double area = 0.0;
    glm::dvec3 mean(0.0);
    const auto forEach = [&mesh](auto use) {
        for (const auto& t : mesh.triangles) {
            const std::array<glm::dvec3, 3> corners{glm::dvec3(mesh.vertices[t[0]]), glm::dvec3(mesh.vertices[t[1]]),
                                                    glm::dvec3(mesh.vertices[t[2]])};
            use(corners, (corners[0] + corners[1] + corners[2]) / 3.0,
                0.5 * glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0])));
        }
    };
    forEach([&](const auto&, const glm::dvec3& middle, double weight) {
        area += weight;
        mean += weight * middle;
    });
    if (!(area > 0.0))
        return m;
    mean /= area;
    forEach([&](const auto& corners, const glm::dvec3& middle, double weight) {
        for (int r = 0; r < 3; ++r)
            for (int c = 0; c < 3; ++c) {
                double sum = 9.0 * (middle[r] - mean[r]) * (middle[c] - mean[c]);
                for (const glm::dvec3& corner : corners)
                    sum += (corner[r] - mean[r]) * (corner[c] - mean[c]);
                m[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)] += weight / area * sum / 12.0;
            }
    });
    return m;
}

/// Turns a symmetric matrix and its eigenvectors so that m[p][q] becomes zero.
void rotate(Matrix& m, Matrix& vectors, std::size_t p, std::size_t q)
{
    const double angle = 0.5 * std::atan2(2.0 * m[p][q], m[q][q] - m[p][p]);
    const double cosine = std::cos(angle);
    const double sine = std::sin(angle);
    const auto turn = [cosine, sine](double& a, double& b) {
        const double before = a;
        a = cosine * before - sine * b;
        b = sine * before + cosine * b;
    };
    for (std::size_t k = 0; k < 3; ++k)
        turn(m[k][p], m[k][q]);
    for (std::size_t k = 0; k < 3; ++k) {
        turn(m[p][k], m[q][k]);
        turn(vectors[k][p], vectors[k][q]);
    }
}

}  // namespace

/// By Jacobi rotations: Golub and Van Loan, Matrix Computations, section 8.5.
PrincipalAxes principalAxes(const TriangleMesh& mesh)
{
    Matrix m = covarianceOf(mesh);
    Matrix vectors{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
    constexpr std::array<std::pair<std::size_t, std::size_t>, 3> kPlanes{{{0, 1}, {0, 2}, {1, 2}}};
    for (int sweep = 0; sweep < kSweeps; ++sweep)
        for (const auto& [p, q] : kPlanes)
            if (m[p][q] != 0.0)
                rotate(m, vectors, p, q);
    std::array<std::size_t, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(), [&m](std::size_t a, std::size_t b) { return m[a][a] > m[b][b]; });
    PrincipalAxes found;
    for (std::size_t k = 0; k < 3; ++k) {
        found.axes[k] = {vectors[0][order[k]], vectors[1][order[k]], vectors[2][order[k]]};
        found.spread[static_cast<int>(k)] = std::sqrt(std::max(0.0, m[order[k]][order[k]]));
    }
    return found;
}

}  // namespace core::mesh
