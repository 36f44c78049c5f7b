// The options of one run of the main job, in addition to its project.
#pragma once

#include "dip/FilmFrame.h"
#include "traveller/Motion.h"

#include <QImage>

namespace dipwright {

struct ImmersionResult;

struct JobOptions {
    QString solver;          // replaces the project's solver; empty: uses the project's
    QImage filmImage;        // replaces the reverse texture; null: uses the reverse texture
    QImage filmInks;         // the film image's amounts of ink (base/InkPicture.h); null: none
    bool chessboard = false; // uses the built-in chessboard as film image
    bool printsTexture() const { return !chessboard && filmImage.isNull(); }
    // Estimates the numerical error of each sheet from coarser dips. They take about a fifth of the
    // work of the job's dips and run at the same time if cores are free. Films that are refined are
    // always judged.
    bool estimatesNumericalError = true;
    // Makes a draft (JobDraft.h): the proof has this size, relative to its full size; there is no
    // coverage picture and no read-back error. None: makes the whole result.
    std::optional<double> draftPictures;
    // Measures how much each sheet depends on the assumed laws. Simulates each dip eight more times
    // (LawChanges.h).
    bool variesLaws = false;
    // Repeats dips with smaller cells until their sheets can be printed, as far as the film's
    // settings allow (FilmRefinement.h). False: ImmersionResult::finer says what is left to do.
    bool refines = true;
    // Makes a cradle for each dip (JobCradles.h). Takes some seconds per cradle.
    bool makesCradles = false;
    // Computes how far colours may land from their places within the project's tolerances. Takes
    // dozens of dips (JobTolerances.h).
    bool computesTolerances = false;
    // Template of the motion files; none: standardMotionTemplate() (traveller/Motion.h).
    std::optional<MotionTemplate> motion;
    // Called on the working thread with the immersion's number and each frame of its film. Has no
    // effect on the result.
    std::function<void(std::size_t, const FilmFrame&)> observer;
    // Called with an immersion's number and result as soon as its sheet is made. May be called from
    // any thread; other dips may still be running.
    std::function<void(std::size_t, const ImmersionResult&)> finished;
};

} // namespace dipwright
