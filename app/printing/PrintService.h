// Printing sheets at true size: everything is judged before anything is sent, and a job is followed
// until it is on paper.
#pragma once

#include "base/Error.h"
#include "base/Progress.h"
#include "printing/PrintHistory.h"
#include "printing/PrintSystem.h"
#include "settings/Profile.h"
#include "sheet/page/CalibrationPage.h"
#include "sheet/page/Sheet.h"

#include <QStringList>
#include <chrono>

namespace dipwright {

struct PrintRequest {
    QString printer;
    int copies = 1;
    // Scales, margins and colours of the printer; none: true scale and sRGB.
    std::optional<PrinterProfile> profile;
    // Cut a sheet that no paper of the printer is made for into pieces of the largest one loaded,
    // or any sheet into pieces of the media named.
    bool tile = false;
    QString tilePaper;
    bool acceptMonochrome = false; // print a coloured sheet in grey
    bool acceptClipping = false;   // lose what lies where the printer does not reach
    bool acceptOtherPaper = false; // the paper is not loaded, as far as the printer knows
    PrintSource source;            // for the history
};

// What will be sent, and what to say about it beforehand.
struct PrintPlan {
    PrinterInfo printer;
    PrintTask task;
    QStringList warnings;
    std::optional<PrintRecord> record; // for the history; none of a page of rulers
};

// Judges and prepares one sheet. Throws Error, one sentence that says what to do, when the printer
// is unknown, stopped, refuses jobs or scales pages unasked; has no such paper, or not loaded;
// prints grey only; does not reach colour near the sheet's edge; and when the sheet is larger than
// every paper of the printer and is not to be tiled. Nothing is sent.
PrintPlan planPrint(PrintSystem& system, const Sheet& sheet, const PrintRequest& request);

// The same for a calibration page, whose scales are its own and not those of the request's profile.
// Refused as well where the printer does not reach the page's rulers.
PrintPlan planCalibration(PrintSystem& system, const CalibrationPage& page,
                          const PrintRequest& request);

// The plans of several sheets: all are judged before the first is sent, so that a job is never
// printed by half.
std::vector<PrintPlan> planPrints(PrintSystem& system, const std::vector<Sheet>& sheets,
                                  const PrintRequest& request);

// How a job has ended that is not known to be printed: what is to be said of it, and what the
// history keeps.
class NotPrinted : public Error {
public:
    NotPrinted(PrintFate fate, const QString& message, const QString& where)
        : Error(message, where), fate_(fate) {}
    PrintFate fate() const { return fate_; }

private:
    PrintFate fate_;
};

// Follows a job that was submitted until it is printed ("HandedOver" where nobody can tell), asking
// a few times a second. Throws NotPrinted when it fails, is cancelled by somebody else, when the
// printer stops, or has not answered for as long as `patience`: the job is then cancelled, so that
// it does not come out unasked later. Of a printer that cannot be asked (PrinterInfo::tellsPrinted)
// a job is left to its queue, with NotPrinted, when that has told nothing new of it for ten times
// as long. Tells by `progress` what the printer says meanwhile, "out of paper"; cancelled by it:
// cancels the job and throws Cancelled. Error where the print system does not answer.
JobState followJob(PrintSystem& system, const PrintJob& job, const Progress& progress,
                   std::chrono::milliseconds patience = std::chrono::minutes(1));

// Hears of each job when it has come to its end.
using JobEndObserver = std::function<void(const PrintTask&, const PrintJob&, JobState)>;

struct PrintEnd {
    JobState state = JobState::Waiting; // of the last job
    QString notKept;                    // why the history does not have them all; empty: it has
};

// Sends what was planned, one job after the other, each followed as above and kept in the history,
// with its end whatever that is.
PrintEnd printPlans(PrintSystem& system, const std::vector<PrintPlan>& plans,
                    const PrintHistory& history, const Progress& progress,
                    const JobEndObserver& ended = {});

} // namespace dipwright
