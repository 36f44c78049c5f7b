// What was printed: when, on what, and from which sheet, by the job number that stands on it. Kept
// with the user's data, a small file a print, so that any number of programs may write at once, on
// several machines too.
#pragma once

#include "settings/Profile.h"

#include <QDateTime>
#include <QSizeF>
#include <vector>

namespace dipwright {

struct Project;
struct Sheet;

// What is known of it. `Sent` stays where the program ended before it knew. `Failed`: it was not
// taken, or given up; `Stopped`: the printer stopped, or did not answer, and the job was taken
// back; `Unknown`: nobody tells, it may be on paper.
enum class PrintFate {
    Sent,
    Printed,
    HandedOver,
    WrittenToFile,
    Cancelled,
    Failed,
    Stopped,
    Unknown
};

// Where a sheet that is printed comes from, as far as the sheet does not say.
struct PrintSource {
    QString projectFile; // absolute; empty: never saved
    QString film;        // its profile's name and lot; empty: it has none
};
PrintSource printSource(const Project& project, const QString& projectFile);

struct PrintRecord {
    QString id; // the name of its file; empty: not kept yet
    QDateTime when;
    QString job;                // the job number on the sheet, JobLine::hash
    QString project, immersion; // by name
    PrintSource source;
    QString printer;    // the system's name of it …
    QString file;       // … or the file it was written to, absolute
    QString profile;    // the printer's; empty: true size and sRGB
    QString mediumName; // the printer's word for it, or empty
    QSizeF mediumSize;  // mm
    int copies = 1;
    PrintFate fate = PrintFate::Sent;
    QString reason; // why it was not printed, or why that is not known
};

// A record of the sheet, before it is sent, on a medium of `mediumSize` mm.
PrintRecord recordOf(const Sheet& sheet, const PrintSource& source,
                     const std::optional<PrinterProfile>& profile, QSizeF mediumSize);

// "Printed", "Failed: out of paper": what became of it, in words.
QString fateText(const PrintRecord& record);

// Where the history cannot be written for this reason: what to say of it.
QString notKeptText(const QString& reason);

class PrintHistory {
public:
    // Far more than anybody looks through; the oldest go first.
    static constexpr int mostRecords = 5000;

    // DIPWRIGHT_PRINT_HISTORY, or "prints" in the user's folder for program data.
    static QString standardFolder();

    explicit PrintHistory(const QString& folder = standardFolder());

    // The newest first. Files that are no records are passed over.
    std::vector<PrintRecord> records() const;
    // Writes the record, whole or not at all: a new one, which is given its time and its id, or
    // over what was kept of it. Empty when done, else why not: nobody wants a print to fail for it.
    QString keep(PrintRecord& record) const;

private:
    QString folder_;
};

} // namespace dipwright
