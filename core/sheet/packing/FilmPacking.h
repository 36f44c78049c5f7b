// Packs several jobs, and several copies of them, on one film. The inked part of each sheet is cut
// out, given its own marks, job line and code, and placed beside the others on whole pixels.
#pragma once

#include "sheet/packing/RectanglePacking.h"
#include "sheet/page/Sheet.h"

#include <QMarginsF>

namespace dipwright {

inline constexpr double leastPieceMargin = 7; // mm that the marks need
inline constexpr int mostPieces = 2000;       // largest number of pieces of all jobs together
inline constexpr int mostFilms = 99;
// mm, longest film. A page of a PDF may have 14 400 points (ISO 32000-1, annex C.2).
inline constexpr double mostFilmLength = 5000;

// The film that takes the pieces.
struct PackingFilm {
    // Size in mm. For a roll: its width, and the greatest length that may be used; the roll is cut
    // off after the last piece.
    QSizeF size{210, 297};
    bool isRoll = false;
    // Whether the pieces are whole sheets with their own marks, and cut marks between them, as for
    // an unattended series on a roll. Otherwise their inked parts are cut out.
    bool wholeSheets = false;
    Millimetres spacing{3}; // between two pieces
    // Least width of bare film round the inked part. It is wider if a cut contour round the ink and
    // its bleed need it, so that they stay clear of the piece's marks.
    Millimetres margin{leastPieceMargin};
    QMarginsF edges{5, 5, 5, 10}; // mm without pieces, for the ruler and the job line
};

struct PieceToPack {
    Sheet sheet;
    int dip = 1; // number of the dip in its project, from 1
    int copies = 1;
    // Whether the image may be turned. Film swells more along its web, so turning may distort it.
    Turning turning = Turning::Never;
};

struct PlannedPiece {
    std::size_t piece = 0; // index among the pieces to pack
    int copy = 1;          // among all copies of the same dip of the same job, from 1
    QRect box;             // place on the film, pixels
    bool turned = false;
};

struct PlannedFilm {
    QSizeF size; // mm
    QSize pixels;
    std::vector<PlannedPiece> pieces; // from top to bottom and left to right
    double used = 0;                  // share of the film that the pieces take, 0 … 1
};

struct FilmPlan {
    std::vector<QRect> inked; // box around the ink in each sheet's image, pixels
    std::vector<PlannedFilm> films;
};

// Throws Error if there are too many pieces or none, or if their resolutions, numbers of passes or
// cut contours differ. The sheets need no pictures, so that this can be called before the dips.
void checkSettings(const std::vector<PieceToPack>& pieces);

// Plans the films. Throws Error as checkSettings() does, and if a piece has no ink or is larger
// than the film, the white layers differ, a cut contour round the ink leaves a whole sheet, or a
// limit above is exceeded.
FilmPlan planFilms(const std::vector<PieceToPack>& pieces, const PackingFilm& film);

// Tells whether the films lose wanted colours or amounts of ink of a piece, because the pieces
// differ in their ink settings or in the spaces of their inks.
bool losesInks(const std::vector<PieceToPack>& pieces);

// Returns the film `number`, counted from 0, as a sheet that can be written and printed. Each
// picture keeps the pixels of its own sheet, turned if the piece is turned. The pictures of a film
// with more than `mostKeptPixels` are made on demand, so that its length does not matter. Needs a
// QGuiApplication for whole sheets only.
Sheet filmSheet(const std::vector<PieceToPack>& pieces, const PackingFilm& film,
                const FilmPlan& plan, std::size_t number, qint64 mostKeptPixels = 32'000'000);

} // namespace dipwright
