// Records each print: when, on which printer, and from which sheet. The sheet is identified by the
// job number on it. Each print is recorded in its own small file, in the user's folder for program
// data. So several programs on several machines can write at the same time.
#pragma once

#include "settings/Profile.h"

#include <QDateTime>
#include <QSizeF>
#include <vector>

namespace dipwright {

struct Project;
struct Sheet;

// The known outcome of a print. `Sent`: the program ended before the outcome was known. `Failed`:
// the job was refused or aborted. `Stopped`: the printer stopped or did not answer, and the job was
// cancelled. `Unknown`: the outcome cannot be queried; the sheet may have been printed.
enum class PrintOutcome {
    Sent,
    Printed,
    HandedOver,
    WrittenToFile,
    Cancelled,
    Failed,
    Stopped,
    Unknown
};

// The origin of a printed sheet, in addition to the data on the sheet.
struct PrintSource {
    QString projectFile; // absolute path; empty if the project was never saved
    QString film;        // name and lot of the film's profile; empty without a profile
};
PrintSource printSource(const Project& project, const QString& projectFile);

struct PrintRecord {
    QString id; // name of the record's file; empty if it is not stored yet
    QDateTime when;
    QString job;                // the job number on the sheet, JobLine::hash
    QString project, immersion; // names of the project and the dip
    PrintSource source;
    QString printer;    // the printer's name in the system; empty for a file
    QString file;       // the file that was written, absolute path; empty for a printer
    QString profile;    // name of the printer profile; empty: true size and sRGB
    QString mediumName; // the printer's name for the paper, or empty
    QSizeF mediumSize;  // mm
    int copies = 1;
    PrintOutcome fate = PrintOutcome::Sent;
    QString reason; // why the sheet was not printed, or why the outcome is unknown
};

// Returns a record of the sheet before it is sent. Its medium has the size `mediumSize`, mm.
PrintRecord recordOf(const Sheet& sheet, const PrintSource& source,
                     const std::optional<PrinterProfile>& profile, QSizeF mediumSize);

// Returns the outcome in words: "Printed", "Failed: out of paper".
QString outcomeText(const PrintRecord& record);

// Returns the message for the user when the history cannot be written for this reason.
QString historyErrorText(const QString& reason);

class PrintHistory {
public:
    // If there are more records, the oldest are deleted.
    static constexpr int mostRecords = 5000;

    // DIPWRIGHT_PRINT_HISTORY, or "prints" in the user's folder for program data.
    static QString standardFolder();

    explicit PrintHistory(const QString& folder = standardFolder());

    // Newest first. Skips files that are not records.
    std::vector<PrintRecord> records() const;
    // Writes the record atomically. A new record gets its time and id; an existing record is
    // overwritten. Returns an empty string, or the reason of a failure. Does not throw, because a
    // print must not fail because of its history.
    QString keep(PrintRecord& record) const;

private:
    QString folder_;
};

} // namespace dipwright
