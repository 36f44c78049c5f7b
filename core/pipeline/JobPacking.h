// Packs the sheets of several projects onto shared films and writes the films' files.
#pragma once

#include "pipeline/JobResult.h"
#include "sheet/packing/FilmPacking.h"

namespace dipwright {

struct PackSettings {
    PackingFilm film;
    FeedDirection feed = FeedDirection::ShortEdgeFirst; // for cut film, not for a roll
    bool mayTurn = false; // allows turning if the film swells equally in both directions
};

// Returns whether a project's piece must, may or must not be turned. A film swells more along its
// web, and each picture is made for one direction of the web. A piece is turned if its web runs
// across the web of this film, and not turned if both webs have the same direction. If its film
// swells equally in both directions, `mayTurn` decides.
Turning turningOf(const Project& project, const PackSettings& settings);

// Returns whether a project's whole sheets must, may or must not be turned on a roll.
Turning turningOnRoll(const Project& project);

struct ProjectToPack {
    Project project;
    int copies = 1;
};
// Throws Error if the projects' settings do not let their sheets share a film. Call it before the
// dips.
void checkProjects(const std::vector<ProjectToPack>& projects);

// Returns the sheets of a finished job as pieces, each `copies` times.
std::vector<PieceToPack> piecesOf(const JobResult& result, int copies,
                                  const PackSettings& settings);

// The pieces and their places on the films.
struct PackedFilms {
    std::vector<PieceToPack> pieces;
    PackSettings settings;
    FilmPlan plan;
};
// Places the pieces on films. Throws Error as planFilms() does.
PackedFilms packedFilms(std::vector<PieceToPack> pieces, const PackSettings& settings);
// Returns the sheet of film `number`, counted from 0.
Sheet sheetOf(const PackedFilms& films, std::size_t number);

// Describes each film in one sentence: size, number of pieces and used share.
QStringList filmsText(const PackedFilms& films);
// Returns sentences, without full stops, about what the films do not keep of their jobs.
QStringList filmsWarnings(const PackedFilms& films);
// Returns sentences, without full stops, about the plates that writeFilms() leaves out, because it
// knows no printer.
QStringList lostInFiles(const PackedFilms& films);

// Returns the names of all files that writeFilms() may write or replace.
QStringList filmFiles();
// Throws Error if writeFilms() cannot write into `folder`. Call it before the work begins.
void checkFilmsFolder(const QString& folder);
// Writes film-N.pdf, .png and .tif for each film, and films.json, into `folder`
// (docs/files-and-commands.md, "Packed films"). Replaces all earlier files or none
// (disk/FolderTransaction.h).
// Needs a QGuiApplication. Throws Error or Cancelled.
void writeFilms(const PackedFilms& films, const QString& folder, const Progress& progress);

} // namespace dipwright
