// Closed forms of the dip (docs/film-model.md, "Closed forms"): a body of revolution dips into a
// water-supported film that is held at a distant ring. The elastic film has no tension at rest and
// the linear in-plane equilibrium u = A·R + B/R; the viscous film keeps its volume as it flows.
#pragma once

#include <functional>
#include <vector>

namespace dipwright {

// A body of revolution about Y that stands on its pole at (0, 0): its radius by the arc length from
// the pole, and the arc length of a surface point from its distance from the axis and height over
// the pole. mm.
struct Meridian {
    std::function<double(double arc)> radius;
    std::function<double(double radius, double height)> arc;
    double fullArc = 0;   // as far as the comparison goes
    double fullDepth = 0; // how deep the pole is then
};
Meridian sphereMeridian(double radius, double polarAngle);
// Half-axes across (`across`) and along Y, to the polar parameter `parameter` (radians, π/2:
// equator).
Meridian spheroidMeridian(double across, double along, double parameter);
Meridian coneMeridian(double halfAngle, double contactRadius);

enum class FilmLaw { Elastic, Viscous };

// The film radius R of the point that ends at arc length s, integrated (Runge–Kutta 4) from the
// pole:
//   elastic   dR/ds = 1/λr,  λr = 1 + A − B/R²,  with A·R + B/R = a − R and B = −A·Ro²
//   viscous   dR/ds = a/(J·R),  J = (Ro² − a²)/(Ro² − R²)
// Ro: the radius of the ring that holds the film. As Ro grows these become those of a large film.
class ClosedForm {
public:
    ClosedForm(const Meridian& profile, FilmLaw law, double ringRadius);
    double filmRadius(double arc) const; // linear between samples 0.001 mm apart or less

private:
    double step_;
    std::vector<double> radii_;
};

// The film radius of what ends inside a lying torus (a tube of radius ρ round a circle of radius c,
// its axis upright) at the angle θ round the tube from its lowest circle inwards. The film inside
// the contact circle, of radius a = c − ρ·sin θ there, is a disc that is stretched alike in all
// directions (u = A·R), elastic or viscous, whatever lies outside: λm = λθ = a/R, so
//   dR/dθ = −ρ·R/a,  R = c·exp(−∫ρ/a dθ).
double insideTorusFilmRadius(double circleRadius, double tubeRadius, double angle);

} // namespace dipwright
