// The film, the body and the numerical error of one dip, as arrays.
#include "python/Arrays.h"
#include "python/Values.h"

#include "film/DippedFilm.h"
#include "python/Parts.h"

namespace dipwright::python {
namespace {

// The parts of a dip are Python classes of their own, and keep the whole result.
struct Film : Dip {
    const LaidFilm& laid() const { return *(**this).laid; }
    const DippedFilm& dipped() const { return laid().film(); }
    py::ssize_t points() const { return py::ssize_t(dipped().positions.size()); }
    py::ssize_t triangles() const { return py::ssize_t(laid().triangles().size()); }
};
struct Body : Dip {
    const TriangleMesh& mesh() const { return (**this).body->mesh; }
};
struct Certainty : Dip {
    const NumericalErrorEstimate& estimate() const { return *(**this).numericalError; }
};

py::array pointArray(const Dip& dip, const std::vector<Eigen::Vector3f>& points) {
    return sharedArray(dip.owner(), reinterpret_cast<const float*>(points.data()),
                       {py::ssize_t(points.size()), 3});
}

py::array triangleArray(const Dip& dip,
                        const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    return sharedArray(dip.owner(), reinterpret_cast<const std::uint32_t*>(triangles.data()),
                       {py::ssize_t(triangles.size()), 3});
}

template <typename Value>
py::array valueArray(const Dip& dip, const std::vector<Value>& values) {
    return sharedArray(dip.owner(), values.data(), {py::ssize_t(values.size())});
}

py::array restArray(const Film& film) {
    std::vector<float> rest;
    rest.reserve(2 * std::size_t(film.points()));
    for (std::size_t point = 0; point < std::size_t(film.points()); ++point) {
        const Eigen::Vector2f place = restPosition(film.dipped().grid, point);
        rest.insert(rest.end(), {place.x(), place.y()});
    }
    return ownedArray(std::move(rest), 2);
}

py::array stateArray(const Film& film) {
    return sharedArray(film.owner(),
                       reinterpret_cast<const std::uint8_t*>(film.dipped().states.data()),
                       {film.points()});
}

py::array markArray(const Film& film) {
    return film.dipped().marks.empty()
               ? ownedArray(std::vector<std::uint8_t>(std::size_t(film.points())))
               : valueArray(film, film.dipped().marks);
}

py::array stretchArray(const Film& film) {
    static_assert(sizeof(PrincipalStretch) == 2 * sizeof(float));
    return sharedArray(film.owner(), reinterpret_cast<const float*>(film.laid().stretches().data()),
                       {film.triangles(), 2});
}

// A place that is not on the body has the triangle −1, which is SurfacePoint::noTriangle.
py::array surfaceTriangles(const Film& film) {
    const std::vector<SurfacePoint>& surface = film.laid().contact().surface;
    return readOnly(py::array_t<std::int32_t>(
        {film.points()}, {py::ssize_t(sizeof(SurfacePoint))},
        reinterpret_cast<const std::int32_t*>(&surface.data()->triangle), capsuleOf(film.owner())));
}

py::array surfaceWeights(const Film& film) {
    const std::vector<SurfacePoint>& surface = film.laid().contact().surface;
    return readOnly(
        py::array_t<float>({film.points(), py::ssize_t(3)},
                           {py::ssize_t(sizeof(SurfacePoint)), py::ssize_t(sizeof(float))},
                           surface.data()->weights.data(), capsuleOf(film.owner())));
}

py::array transformArray(const Body& body) {
    const Eigen::Matrix<double, 4, 4, Eigen::RowMajor> matrix = (*body).body->modelToPose.matrix();
    return ownedArray(std::vector<double>(matrix.data(), matrix.data() + matrix.size()), 4);
}

// A distribution as Python has it: properties with one text for all of them.
template <typename Class, typename Get>
void addDistribution(Class& type, const Get& get, const std::string& what) {
    const auto add = [&](const char* name, double Distribution::*member, const char* text) {
        type.def_property_readonly(
            name, [=](const typename Class::type& object) { return get(object).*member; },
            (std::string(text) + what).c_str());
    };
    add("mean", &Distribution::mean, "Mean ");
    add("percentile95", &Distribution::percentile95, "95th percentile of the ");
    add("maximum", &Distribution::maximum, "Largest ");
}

} // namespace

void bindFilm(py::module_& module) {
    py::class_<Film>(
        module, "Film",
        "The film of one dip at its end. Arrays share its memory and are read-only.\n\n"
        "A film has columns × rows points; point (column i, row j) has the index\n"
        "j · columns + i, so an array of points becomes a grid by\n"
        "reshape(rows, columns, ...). Its triangles are two for each cell.")
        .def_property_readonly(
            "columns", [](const Film& film) { return film.dipped().grid.columns; },
            "Number of columns, along the sheet's X.")
        .def_property_readonly(
            "rows", [](const Film& film) { return film.dipped().grid.rows; },
            "Number of rows, along the film's Z, down the sheet.")
        .def_property_readonly(
            "positions", [](const Film& film) { return pointArray(film, film.dipped().positions); },
            "Positions after the dip: (points, 3) float32, mm, in the body's pose frame.")
        .def_property_readonly(
            "places",
            [](const Film& film) { return pointArray(film, film.laid().contact().places); },
            "Places on the body: (points, 3) float32, mm, pose frame. For points off the body, "
            "their\n"
            "positions.")
        .def_property_readonly("rest", restArray,
                               "Flat film on the water before the dip, swell included: (points, 2) "
                               "float32, mm, x and z\nfrom the film's centre. A copy.")
        .def_property_readonly(
            "states", stateArray,
            "State of each point: (points,) uint8; 0 free, 1 adhered, 2 trapped under an "
            "overhanging face.")
        .def_property_readonly(
            "marks", markArray,
            "Marks of each point: (points,) uint8, bits; 1 torn, 2 released, 4 did not converge.")
        .def_property_readonly("surface_triangles", surfaceTriangles,
                               "Triangle of the body on which each point lies: (points,) int32; -1 "
                               "off the body.")
        .def_property_readonly("surface_weights", surfaceWeights,
                               "Barycentric weights of each point in that triangle: (points, 3) "
                               "float32.")
        .def_property_readonly(
            "triangles",
            [](const Film& film) { return triangleArray(film, film.laid().triangles()); },
            "Points of each triangle of the film: (triangles, 3) uint32.")
        .def_property_readonly(
            "stretches", stretchArray,
            "Principal stretches of each triangle: (triangles, 2) float32, the larger first; final "
            "length\ndivided by rest length.")
        .def_property_readonly(
            "painted",
            [](const Film& film) { return valueArray(film, film.laid().contact().painted); },
            "Whether each triangle is on the body: (triangles,) uint8, 0 or 1.")
        .def_property_readonly(
            "point_stretches",
            [](const Film& film) { return ownedArray(pointStretches(film.dipped())); },
            "Mean stretch at each point: (points,) float32. A copy.")
        .def_property_readonly(
            "steps", [](const Film& film) { return film.dipped().steps; },
            "Number of steps of the solver.")
        .def_property_readonly(
            "seconds", [](const Film& film) { return film.dipped().wallSeconds; },
            "Time that the solver took, s.")
        .def_property_readonly(
            "used", [](const Film& film) { return usedShare(film.laid()); },
            "Share of the film inside the bounding box of what paints, 0 to 1.")
        .def("__repr__", [](const Film& film) {
            const auto& grid = film.dipped().grid;
            return QStringLiteral("<Film of %1 × %2 points>").arg(grid.columns).arg(grid.rows);
        });

    py::class_<Body>(module, "Body",
                     "The part in its pose for one dip. Arrays share its memory and are read-only.")
        .def_property_readonly(
            "positions", [](const Body& body) { return pointArray(body, body.mesh().positions); },
            "Corners: (positions, 3) float32, mm, in the pose frame.")
        .def_property_readonly(
            "triangles",
            [](const Body& body) { return triangleArray(body, body.mesh().triangles); },
            "Corners of each triangle: (triangles, 3) uint32, counterclockwise from outside.")
        .def_property_readonly(
            "covered", [](const Body& body) { return valueArray(body, (*body).coverage->covered); },
            "Whether at least half of each triangle is painted or masked: (triangles,) uint8, 0 or "
            "1.")
        .def_property_readonly(
            "model_to_pose", transformArray,
            "Maps model coordinates to the pose frame: (4, 4) float64, mm. A copy.")
        .def_property_readonly(
            "height", [](const Body& body) { return (*body).body->height; },
            "From the lowest to the highest point, mm.")
        .def("__repr__", [](const Body& body) {
            return QStringLiteral("<Body of %1 triangles>").arg(body.mesh().triangles.size());
        });

    py::class_<Certainty> certainty(
        module, "Certainty",
        "The numerical error of one sheet: how far its picture may be off because of the film's\n"
        "cells and the solver's steps.");
    addDistribution(
        certainty,
        [](const Certainty& object) -> const Distribution& { return object.estimate().offBy; },
        "numerical error on the painted area, mm.");
    certainty
        .def_property_readonly(
            "point_errors",
            [](const Certainty& object) {
                return valueArray(object, object.estimate().pointErrors);
            },
            "Numerical error of each film point: (points,) float32, mm; 0 off the body, NaN where\n"
            "unknown: everywhere if the coarser films do not follow the part. Empty if the\n"
            "estimate failed.")
        .def_property_readonly(
            "failure", [](const Certainty& object) { return object.estimate().failure; },
            "Why there is no estimate; empty if there is one, or if the coarser films do not\n"
            "follow the part.")
        .def("__repr__", [](const Certainty& object) {
            const NumericalErrorEstimate& estimate = object.estimate();
            if (estimate.isKnown()) {
                return QStringLiteral("<Certainty: 95 % within %1 mm>")
                    .arg(estimate.offBy.percentile95, 0, 'f', 2);
            }
            return QStringLiteral("<Certainty: %1>")
                .arg(estimate.failure.isEmpty() ? QStringLiteral("not known") : estimate.failure);
        });
}

py::object filmOf(const Dip& dip) {
    return py::cast(Film{dip});
}

py::object bodyOf(const Dip& dip) {
    return py::cast(Body{dip});
}

py::object certaintyOf(const Dip& dip) {
    return dip->numericalError ? py::cast(Certainty{dip}) : py::none();
}

} // namespace dipwright::python
