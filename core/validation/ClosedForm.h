// Closed forms of the dip (docs/film-model.md, "Closed forms"): a body of revolution dips into a
// water-supported film that is held at a distant ring or ends free, and a long lying cylinder into
// one that ends free. The elastic film has no tension at rest and the linear in-plane equilibrium
// r = α·ρ + β/ρ; the viscous film keeps its volume as it flows. Either may grow as it floats.
#pragma once

#include <functional>
#include <vector>

namespace dipwright {

// A body of revolution about Y that stands on its pole at (0, 0): its radius and its height over
// the pole by the arc length from there, and the arc length of a surface point from its distance
// from the axis and its height. mm.
struct Meridian {
    std::function<double(double arc)> radius;
    std::function<double(double arc)> height;
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
enum class FilmEdge { Held, Free };

// The film that floats when the dip begins.
struct FloatingFilm {
    FilmLaw law = FilmLaw::Elastic;
    FilmEdge edge = FilmEdge::Held;
    double edgeRadius = 0; // mm, of a round film's edge
    // How many times as long as in the beginning it is, left to itself, when the body's pole is so
    // many mm under water.
    std::function<double(double depth)> grown = [](double) { return 1.0; };
};

// The film radius R of the point that ends at arc length s, integrated (Runge–Kutta 4) from the
// pole, with a(s) the body's radius, Ro the film's and g its growth when the water is at s:
//   elastic   dR/ds = 1/(2αg − a/R),  αg = (Ro² − aR)/(Ro² − R²) held, (aR + 2gRo²)/(R² + 2Ro²)
//   free viscous   dR/ds = a/(J·R),  J = (Ro² − a²)/(Ro² − R²) held
// and in a viscous film with a free edge  d(ln J)/ds = 2((a′ − 1)a + 2r²·g′/g)/(a² + 2r²)  with the
// edge at r² = a² + J(Ro² − R²). As Ro grows these become those of a large film.
class ClosedForm {
public:
    ClosedForm(const Meridian& profile, const FloatingFilm& film);
    double filmRadius(double arc) const; // linear between samples 0.001 mm apart or less

private:
    double step_;
    std::vector<double> radii_;
};

// The place X, on the film, of what ends at arc length s from the lowest line of a lying cylinder
// that is long against the film's width, whose edges are free (edgeRadius is not read). With g₀ the
// growth at the first contact:
//   elastic   dX/ds = 3/(4g − g₀),    viscous   dX/ds = 1/(g₀·(g/g₀)^(4/3))
// Along the cylinder everything lies at g₀ times its place on the film.
double filmOnCylinder(double cylinderRadius, double arc, const FloatingFilm& film);

// The film radius of what ends inside a lying torus (a tube of radius ρ round a circle of radius c,
// its axis upright) at the angle θ round the tube from its lowest circle inwards. The film inside
// the contact circle, of radius a = c − ρ·sin θ there, is a disc that is stretched alike in all
// directions (u = A·R), elastic or viscous, whatever lies outside: λm = λθ = a/R, so
//   dR/dθ = −ρ·R/a,  R = c·exp(−∫ρ/a dθ).
double insideTorusFilmRadius(double circleRadius, double tubeRadius, double angle);

} // namespace dipwright
