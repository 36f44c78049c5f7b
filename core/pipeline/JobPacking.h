// Several projects on one film: their sheets as pieces, and the files of the films that they make.
#pragma once

#include "pipeline/JobResult.h"
#include "sheet/packing/FilmPacking.h"

namespace dipwright {

struct PackSettings {
    PackingFilm film;
    FeedDirection feed = FeedDirection::ShortEdgeFirst; // of a film that is no roll
    bool mayTurn = false; // pictures for films that swell alike both ways may be turned
};

// A film swells more along its web, and pictures are made for that: a piece whose own film had it
// across that of this film is turned, one that had it along never is. Where its film swells alike
// both ways it makes no difference, and `mayTurn` decides.
Turning turningOf(const Project& project, const PackSettings& settings);

// The sheets of a job that was run, each `copies` times.
std::vector<PieceToPack> piecesOf(const JobResult& result, int copies,
                                  const PackSettings& settings);

struct PackedFilms {
    std::vector<PieceToPack> pieces;
    PackSettings settings;
    FilmPlan plan;
};
// Throws Error as planFilms() does.
PackedFilms packedFilms(std::vector<PieceToPack> pieces, const PackSettings& settings);
Sheet sheetOf(const PackedFilms& films, std::size_t number);

// A sentence a film: its size, its pieces and how much of it they take.
QStringList filmsText(const PackedFilms& films);

// Throws Error where the files of packed films could not be written into `folder`: worth asking
// before the work.
void checkFilmsFolder(const QString& folder);
// Writes film-N.pdf, .png and .tif of each film and films.json (docs/files-and-commands.md, "Packed
// films") into `folder`. They replace earlier ones, all or none (disk/FolderTransaction.h).
// Needs a QGuiApplication. Throws Error or Cancelled.
void writeFilms(const PackedFilms& films, const QString& folder, const Progress& progress);

} // namespace dipwright
