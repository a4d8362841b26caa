#pragma once

#include "bearing/geometry.hpp"

namespace piae::bearing {

/// Material and groove, which the paper's Table 1 does not give. The defaults are bearing steel and
/// the usual groove of Harris, "Rolling Bearing Analysis", ch. 2 and 6.
struct HertzOptions {
  double youngs_modulus_pa = 207e9;  ///< E
  double poissons_ratio = 0.3;       ///< nu
  double groove_ratio = 0.525;       ///< radius of a raceway's groove / ball diameter, both races
};

/// The curvature of a ball against a race (Harris, eqs 2.26 to 2.32).
struct Curvature {
  double sum_per_m = 0;   ///< sum of the four principal curvatures, in 1/m
  double difference = 0;  ///< F(rho), in [0, 1)
};

Curvature inner_curvature(const Geometry& geometry, const HertzOptions& options = {});
Curvature outer_curvature(const Geometry& geometry, const HertzOptions& options = {});

/// Returns delta*, the dimensionless contact deformation (Harris, eqs 6.25 to 6.31). The axis ratio
/// kappa of the contact ellipse solves F(rho) = ((kappa^2 + 1) E - 2 F) / ((kappa^2 - 1) E), where
/// F and E are the complete elliptic integrals of parameter 1 - 1 / kappa^2. The difference must be
/// in [0, 1).
double contact_deformation(double curvature_difference);

/// Eq. 12: returns the force of one ball on one race divided by deformation^1.5, in N/m^1.5.
double race_stiffness(const Curvature& curvature, const HertzOptions& options = {});

/// Returns K_b of eq. 12, in N/m^1.5: the stiffness of a ball between both races, whose two
/// contacts are in series. Throws Error(bad_input) for an impossible geometry or material.
double contact_stiffness(const Geometry& geometry, const HertzOptions& options = {});

}  // namespace piae::bearing
