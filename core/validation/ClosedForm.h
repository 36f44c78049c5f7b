// Gives the exact solutions of some dips in closed form (docs/film-model.md, "Closed forms"). In
// one kind of dip, a body of revolution dips into a film that is held at a distant ring or has a
// free edge. In the other kind, a long horizontal cylinder dips into a film with free edges. The
// elastic film has no tension at rest, and its equilibrium in the plane is r = α·ρ + β/ρ. The
// viscous film keeps its volume. Both films may grow while floating.
#pragma once

#include <functional>
#include <vector>

namespace dipwright {

// A body of revolution about Y with its pole at (0, 0). `radius` and `height` (over the pole) are
// functions of the arc length from the pole. `arc` returns the arc length of a point from its
// distance to the axis and its height. All in mm.
struct Meridian {
    std::function<double(double arc)> radius;
    std::function<double(double arc)> height;
    std::function<double(double radius, double height)> arc;
    // Arc length up to which a simulated film is compared with the closed form, mm.
    double fullArc = 0;
    double fullDepth = 0; // depth of the pole, in mm, when the contact line is at `fullArc`
};
Meridian sphereMeridian(double radius, double polarAngle);
// `across` and `along` are the half-axes across and along Y. `parameter` is the polar parameter at
// `fullArc`, in radians; π/2 is the equator.
Meridian spheroidMeridian(double across, double along, double parameter);
Meridian coneMeridian(double halfAngle, double contactRadius);

enum class FilmLaw { Elastic, Viscous };
enum class FilmEdge { Held, Free };

// The floating film at the start of the dip.
struct FloatingFilm {
    FilmLaw law = FilmLaw::Elastic;
    FilmEdge edge = FilmEdge::Held;
    double edgeRadius = 0; // radius of a round film, mm
    // Returns the length of the free film divided by its length at the start, when the body's pole
    // is `depth` mm under water.
    std::function<double(double depth)> grown = [](double) { return 1.0; };
};

// Computes which film point ends at the arc length s of the body: R is its radius on the flat film.
// Integrates from the pole by Runge–Kutta 4. a(s) is the body's radius and Ro the film's radius. g
// is the film's growth when the water is at s:
//   elastic   dR/ds = 1/(2αg − a/R)
//             held: αg = (Ro² − aR)/(Ro² − R²);  free: αg = (aR + 2gRo²)/(R² + 2Ro²)
//   viscous   dR/ds = a/(J·R)
//             held: J = (Ro² − a²)/(Ro² − R²)
//             free: d(ln J)/ds = 2((a′ − 1)a + 2r²·g′/g)/(a² + 2r²)
// The free edge is at r² = a² + J(Ro² − R²). For large Ro these equations approach the
// equations of an infinite film.
class ClosedForm {
public:
    ClosedForm(const Meridian& profile, const FloatingFilm& film);
    double filmRadius(double arc) const; // linear between samples 0.001 mm apart or less

private:
    double step_;
    std::vector<double> radii_;
};

// Returns which film point ends on a horizontal cylinder at the arc length s from its lowest line:
// X is its coordinate on the flat film. The cylinder is long compared with the film's width, and
// the film's edges are free (edgeRadius is not used). g₀ is the growth at the first contact:
//   elastic   dX/ds = 3/(4g − g₀),    viscous   dX/ds = 1/(g₀·(g/g₀)^(4/3))
// Along the cylinder, the distance of each point from the middle is g₀ times its distance on the
// film.
double filmOnCylinder(double cylinderRadius, double arc, const FloatingFilm& film);

// Returns which film point ends on the inner side of a torus with a vertical axis: R is its radius
// on the flat film. The torus is a tube of radius ρ around a circle of radius c. θ is the angle
// around the tube from its lowest circle inwards. The contact circle has the radius a = c − ρ·sin
// θ. The film within it is a disc that is stretched equally in all directions, elastic or viscous.
// The film outside the circle has no influence. λm = λθ = a/R, so
//   dR/dθ = −ρ·R/a,  R = c·exp(−∫ρ/a dθ).
double insideTorusFilmRadius(double circleRadius, double tubeRadius, double angle);

} // namespace dipwright
