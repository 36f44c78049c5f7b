// From the body's texture back to the image to print, and forward again.
//
// Film images are pictures of the flat film, ink side up: pixel columns run along +X, pixel rows
// along +Z; the picture's full width is the film's width (film-physics, "Which way up the sheet is").
#pragma once

#include "dip/Coverage.h"

#include <QImage>

namespace dipwright {

struct InkSettings {
    bool compensate = true;    // print D·J so that D shows after the film has stretched by J
    double limit = 2.0;        // the highest optical density that can be printed, a channel
    bool operator==(const InkSettings&) const = default;
};

struct ReverseTextureOptions {
    QSize pixels;              // of the whole film
    double bleed = 2;          // mm that the colour is continued past the painted area
    InkSettings ink;
};

struct ReverseTexture {
    QImage image;              // RGBA8888, sRGB, alpha 0 where nothing is printed
    std::size_t seamTriangles = 0; // film triangles that crossed from chart to chart
    double shortfallArea = 0;  // mm² of body whose density cannot be reached within the ink limit
};

// The image to print so that the dip puts the body's texture where it belongs. All cores,
// deterministic, throws Cancelled.
ReverseTexture reverseTexture(const DippedFilm& film, const FilmContact& contact,
                              const PosedBody& body, const SurfaceQuery& query,
                              const ReverseTextureOptions& options, const Progress& progress);

// Chess squares of `square` mm, black and white, two corners meeting in the film's middle.
QImage chessboard(const solver::FilmGrid& grid, double square, QSize pixels);

// Where film lands on the body: asked for a body surface point, tells the place on the flat film.
class FilmOnBody {
public:
    FilmOnBody(const DippedFilm& film, const FilmContact& contact, const PosedBody& body);
    ~FilmOnBody();
    // The place on the flat film (restPosition's frame) of the film that covers `point` of the body;
    // false where none does. `triangle` gets the film triangle. Any thread.
    bool locate(const SurfacePoint& point, Eigen::Vector2f& rest, std::uint32_t& triangle) const;

private:
    struct Data;
    std::unique_ptr<Data> data_;
};

// Registration error (film-physics §4): for points spread evenly over the painted surface, the
// distance on the body between where a texture point should be and where the sheet puts it.
struct Registration {
    double mean = 0, percentile95 = 0, maximum = 0; // mm
    std::size_t samples = 0;
};
Registration registrationError(const DippedFilm& film, const FilmContact& contact,
                               const PosedBody& body, const SurfaceQuery& query,
                               const FilmOnBody& filmOnBody);

} // namespace dipwright
