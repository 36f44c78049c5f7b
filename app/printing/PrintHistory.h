// Records what was printed: when, on which printer, and from which sheet, by the job number on the
// sheet. Stored with the user's data, one small file for each print. So several programs, on
// several machines, can write at the same time.
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

// Where a printed sheet comes from, in addition to the data on the sheet.
struct PrintSource {
    QString projectFile; // absolute; empty: never saved
    QString film;        // name and lot of its profile; empty: no profile
};
PrintSource printSource(const Project& project, const QString& projectFile);

struct PrintRecord {
    QString id; // the name of its file; empty: not stored yet
    QDateTime when;
    QString job;                // the job number on the sheet, JobLine::hash
    QString project, immersion; // names
    PrintSource source;
    QString printer;    // its name in the system …
    QString file;       // … or the file it was written to, absolute
    QString profile;    // the printer profile; empty: true size and sRGB
    QString mediumName; // the printer's name for it, or empty
    QSizeF mediumSize;  // mm
    int copies = 1;
    PrintOutcome fate = PrintOutcome::Sent;
    QString reason; // why it was not printed, or why the outcome is unknown
};

// A record of the sheet before it is sent, on a medium of `mediumSize` mm.
PrintRecord recordOf(const Sheet& sheet, const PrintSource& source,
                     const std::optional<PrinterProfile>& profile, QSizeF mediumSize);

// The outcome in words: "Printed", "Failed: out of paper".
QString outcomeText(const PrintRecord& record);

// What to tell the user when the history cannot be written for this reason.
QString historyErrorText(const QString& reason);

class PrintHistory {
public:
    // The oldest records are deleted beyond this number.
    static constexpr int mostRecords = 5000;

    // DIPWRIGHT_PRINT_HISTORY, or "prints" in the user's folder for program data.
    static QString standardFolder();

    explicit PrintHistory(const QString& folder = standardFolder());

    // Newest first. Skips files that are not records.
    std::vector<PrintRecord> records() const;
    // Writes the record atomically. A new record gets its time and id; an old one is overwritten.
    // Returns an empty string, or the reason of a failure: a print must not fail because of its
    // history.
    QString keep(PrintRecord& record) const;

private:
    QString folder_;
};

} // namespace dipwright
