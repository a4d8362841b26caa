#pragma once

namespace piae::diffusion {

/// The way from a window x0 to Gaussian noise e: x(u) = a(u) x0 + b(u) e, for u from 0 to 1. A
/// network estimates the velocity v = a'(s) x0 + b'(s) e along the path's own parameter s(u); from
/// x and v follow x0 and e, and the next point of the path.
enum class Path {
  /// Denoising diffusion with the cosine schedule (Nichol and Dhariwal 2021, eq. 17): a = cos(s),
  /// b = sin(s), where a^2 is their alpha bar. v is that of Salimans and Ho (2022, appendix D).
  diffusion,
  /// Conditional flow matching with straight paths (Lipman et al. 2023, Section 4.1, with sigma_min
  /// = 0): a = 1 - s, b = s, s = u, so that v = e - x0.
  flow
};

/// Factors of a point on a path.
struct Point {
  double data;               ///< a
  double noise;              ///< b
  double velocity_of_data;   ///< a'
  double velocity_of_noise;  ///< b'
};

/// Returns the point at u, from 0 (the window) to 1 (noise).
Point point_at(Path path, double u);

/// Factors of x' = of_x x + of_velocity v, the point at another u by the velocity here: for
/// `diffusion` the deterministic step of DDIM (Song, Meng and Ermon 2021, eq. 12 with sigma = 0),
/// for `flow` a straight line.
struct Move {
  double of_x;
  double of_velocity;
};
Move move_between(Path path, double from, double to);

}  // namespace piae::diffusion
