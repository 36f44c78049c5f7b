// Packs several jobs, and several copies of them, on one film. The inked part of each sheet is cut
// out, given its own marks, job line and code, and placed beside the others on whole pixels.
#pragma once

#include "sheet/packing/RectanglePacking.h"
#include "sheet/page/Sheet.h"

#include <QMarginsF>

namespace dipwright {

inline constexpr double leastPieceMargin = 7; // mm that the marks need
inline constexpr int mostPieces = 2000;       // of all jobs together
inline constexpr int mostFilms = 99;

// The film that takes the pieces.
struct PackingFilm {
    // mm. For a roll: its width, and the greatest length that may be used. That length is also
    // limited to what a sheet's image may have. The film is cut off behind the last piece.
    QSizeF size{210, 297};
    bool isRoll = false;
    Millimetres spacing{3};               // between two pieces
    Millimetres margin{leastPieceMargin}; // least width of bare film round the inked part
    QMarginsF edges{5, 5, 5, 10};         // kept free of pieces, mm; ruler and job line stand there
};

struct PieceToPack {
    Sheet sheet;
    int dip = 1; // number of the dip in its project, from 1
    int copies = 1;
    // Film swells more along its web. A film image may be turned only if that does not matter.
    Turning turning = Turning::Never;
};

struct PlannedPiece {
    std::size_t piece = 0; // index among the pieces to pack
    int copy = 1;
    QRect box; // on the film, pixels
    bool turned = false;
};

struct PlannedFilm {
    QSizeF size; // mm
    QSize pixels;
    std::vector<PlannedPiece> pieces; // from top to bottom and left to right
    double used = 0;                  // share of the film that the pieces take, 0 … 1
};

struct FilmPlan {
    std::vector<QRect> inked; // inked box of each sheet's image, pixels
    std::vector<PlannedFilm> films;
};

// Plans the films. Throws Error if there is no piece, a piece without ink, a piece larger than the
// film, sheets of different resolutions, or more than the limits above.
FilmPlan planFilms(const std::vector<PieceToPack>& pieces, const PackingFilm& film);

// Returns the film `number`, counted from 0, ready to be written and printed like any sheet. Each
// picture keeps the pixels of its own sheet, turned if the piece is turned. Needs no
// QGuiApplication.
Sheet filmSheet(const std::vector<PieceToPack>& pieces, const PackingFilm& film,
                const FilmPlan& plan, std::size_t number);

} // namespace dipwright
