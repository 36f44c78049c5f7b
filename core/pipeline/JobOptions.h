// What a run of the main job is asked for beside its project.
#pragma once

#include "dip/FilmFrame.h"
#include "traveller/Motion.h"

#include <QImage>

namespace dipwright {

struct ImmersionResult;

struct JobOptions {
    QString solver;          // in place of the project's, or empty
    QImage filmImage;        // on the film instead of the reverse texture; null: reverse
    bool chessboard = false; // the built-in chessboard as film image
    // Whether coarser dips tell how certain each sheet is: takes up to as long again as the dips,
    // beside them where cores are free.
    bool estimatesCertainty = true;
    // Whether dips with the laws of ours varied tell how much each sheet depends on them: eight
    // more an immersion (LawChanges.h).
    bool variesLaws = false;
    // Whether a cradle is made for each immersion (JobCradles.h): some seconds each.
    bool makesCradles = false;
    // Whether it is told how far colours may land off their places for the tolerances of the
    // project, which takes dozens of dips more (JobTolerances.h).
    bool tellsTolerances = false;
    // Of the motion's files, in place of motionTemplate() (traveller/Motion.h).
    std::optional<MotionTemplate> motion;
    // Called from the working thread with the immersion's number. Has no effect on the result.
    std::function<void(std::size_t, const FilmFrame&)> observer;
    // Called with an immersion's number and result as soon as its sheet is made, from any thread
    // and while others may still be dipped.
    std::function<void(std::size_t, const ImmersionResult&)> finished;
};

} // namespace dipwright
