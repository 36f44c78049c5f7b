// Several jobs, and several copies of them, on one film: what is inked of each sheet is cut out,
// given marks, a job line and a code of its own, and laid beside the others by whole pixels.
#pragma once

#include "sheet/packing/RectanglePacking.h"
#include "sheet/page/Sheet.h"

#include <QMarginsF>

namespace dipwright {

inline constexpr double leastPieceMargin = 7; // mm: as much as marks take
inline constexpr int mostPieces = 2000;       // of all jobs together
inline constexpr int mostFilms = 99;

// What the pieces are laid on.
struct PackingFilm {
    // mm. Of a roll: its width, and how long a piece of it may be at most, and no longer than a
    // sheet's picture may be; it is cut off behind the last piece.
    QSizeF size{210, 297};
    bool isRoll = false;
    Millimetres spacing{3};               // between two pieces
    Millimetres margin{leastPieceMargin}; // of bare film round what is inked, at least
    QMarginsF edges{5, 5, 5, 10};         // of the film, mm; ruler and job line stand there
};

struct PieceToPack {
    Sheet sheet;
    int dip = 1; // which of its project, from 1
    int copies = 1;
    // Film swells more along its web: a picture for it must lie as it was made, or may be turned.
    Turning turning = Turning::Never;
};

struct PlannedPiece {
    std::size_t piece = 0; // its number among those to pack
    int copy = 1;
    QRect box; // on the film, pixels
    bool turned = false;
};

struct PlannedFilm {
    QSizeF size; // mm
    QSize pixels;
    std::vector<PlannedPiece> pieces; // from above to below and left to right
    double used = 0;                  // 0 … 1: the share of it that the pieces take
};

struct FilmPlan {
    std::vector<QRect> inked; // of each sheet's image, pixels
    std::vector<PlannedFilm> films;
};

// Throws Error: no piece, one without ink, one that is larger than the film, sheets of different
// resolutions, more than the limits above.
FilmPlan planFilms(const std::vector<PieceToPack>& pieces, const PackingFilm& film);

// Film `number`, from 0, ready to be written and printed as any sheet is. The pixels of each
// picture are those of its own sheet, turned where it is. Needs no QGuiApplication.
Sheet filmSheet(const std::vector<PieceToPack>& pieces, const PackingFilm& film,
                const FilmPlan& plan, std::size_t number);

} // namespace dipwright
