// Prints sheets at true size. Checks everything before it sends anything, and follows each job
// until it is printed.
#pragma once

#include "base/Error.h"
#include "base/Progress.h"
#include "printing/PrintHistory.h"
#include "printing/PrintSystem.h"
#include "settings/Profile.h"
#include "sheet/packing/FilmPacking.h"
#include "sheet/page/CalibrationPage.h"
#include "sheet/page/Sheet.h"

#include <QStringList>
#include <chrono>

namespace dipwright {

struct PrintRequest {
    QString printer;
    int copies = 1;
    // Scales, margins and colours of the printer. Without a profile: true size and sRGB.
    std::optional<PrinterProfile> profile;
    // Splits the sheet into tiles. Without `tilePaper`, only a sheet that fits no paper of the
    // printer is split, onto the largest loaded paper. With `tilePaper`, any sheet is split onto
    // the paper of that name.
    bool tile = false;
    QString tilePaper;
    bool acceptMonochrome = false; // allows printing a coloured sheet in grey
    bool acceptClipping = false;   // allows losing colour that the printer cannot reach
    // Allows printing on paper that the printer does not report as loaded.
    bool acceptOtherPaper = false;
    // Whether a sheet on a roll lies across it. Film swells more along its web, so that only film
    // that swells equally may be turned.
    Turning turning = Turning::Allowed;
    PrintSource source; // stored in the history
};

// A checked print, ready to be sent, and its warnings for the user.
struct PrintPlan {
    PrinterInfo printer;
    PrintTask task;
    QStringList warnings;
    std::optional<PrintRecord> record; // stored in the history; none for a calibration page
};

// Checks and prepares one sheet. Sends nothing. Throws Error, with one sentence that says what to
// do, in these cases. The printer is unknown or stopped, refuses jobs, or scales pages by itself.
// It does not have the paper, or the paper is not loaded. It prints only grey. It cannot reach
// colour near the sheet's edge. The sheet is larger than every paper and may not be tiled.
PrintPlan planPrint(PrintSystem& system, const Sheet& sheet, const PrintRequest& request);

// Does the same for a calibration page, which has its own scales instead of the profile's. Also
// throws if the printer cannot reach the rulers.
PrintPlan planCalibration(PrintSystem& system, const CalibrationPage& page,
                          const PrintRequest& request);

// Returns the roll of a printer that takes custom sizes: its width, from the profile or as the
// printer reports it, and the length of its longest page, mm. Nothing for other printers.
std::optional<QSizeF> rollSize(const PrinterInfo& printer,
                               const std::optional<PrinterProfile>& profile);

// Returns the margins, in mm, that the printer leaves empty on a film of this size or on a roll.
// They are 0 if the printer reports no paper of this size.
QMarginsF printerMargins(PrintSystem& system, const QString& printer, const PackingFilm& film);

// Plans several sheets. Checks all of them before the first is sent, so that no set of sheets is
// printed only in part. If the profile has a gap for rolls and the printer takes custom sizes, all
// sheets and copies become one series on the roll, or several if the printer's longest page is too
// short: whole sheets with cut marks between them.
std::vector<PrintPlan> planPrints(PrintSystem& system, const std::vector<Sheet>& sheets,
                                  const PrintRequest& request);

// Thrown if a job ended and is not known to be printed. Has the message for the user and the
// outcome for the history.
class NotPrinted : public Error {
public:
    NotPrinted(PrintOutcome fate, const QString& message, const QString& where)
        : Error(message, where), fate_(fate) {}
    PrintOutcome fate() const { return fate_; }

private:
    PrintOutcome fate_;
};

// Follows a submitted job until it is printed, asking a few times a second. Returns HandedOver if
// the outcome cannot be queried. Throws NotPrinted if the job fails, somebody else cancels it, the
// printer stops, or the printer does not answer for `patience`. The job is then cancelled, so that
// it does not print unexpectedly later. A job for a printer that cannot be queried
// (PrinterInfo::reportsPrinted) stays in its queue; NotPrinted is thrown after ten times `patience`
// without news. Reports the printer's messages, such as "out of paper", through `progress`.
// Cancelling through it cancels the job and throws Cancelled. Throws Error if the print system does
// not answer.
JobState followJob(PrintSystem& system, const PrintJob& job, const Progress& progress,
                   std::chrono::milliseconds patience = std::chrono::minutes(1));

// Called for each job that has ended.
using JobEndObserver = std::function<void(const PrintTask&, const PrintJob&, JobState)>;

struct PrintEnd {
    JobState state = JobState::Waiting; // state of the last job
    QString historyFailure; // why some jobs are missing in the history; empty if none is missing
};

// Sends the plans one after the other. Follows each job as followJob() does, and records it with
// its outcome in the history.
PrintEnd printPlans(PrintSystem& system, const std::vector<PrintPlan>& plans,
                    const PrintHistory& history, const Progress& progress,
                    const JobEndObserver& ended = {});

} // namespace dipwright
