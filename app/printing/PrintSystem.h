// What the operating system offers to print with: printers, jobs. One small implementation a
// platform; everything that judges or decides is in PrintService.h.
#pragma once

#include <QByteArray>
#include <QMarginsF>
#include <QPainter>
#include <QSizeF>
#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace dipwright {

// A paper as one printer takes it: the same sheet may be there with margins and without.
struct PrinterMedia {
    QString name;      // the system's own
    QSizeF size;       // mm, as it goes through the printer
    QMarginsF margins; // mm that the printer cannot reach
    bool ready = true; // loaded, as far as the printer says
};

enum class PrinterState { Idle, Printing, Stopped };

struct PrinterInfo {
    QString name;
    QString description; // for people
    bool isDefault = false;
    PrinterState state = PrinterState::Idle;
    QString stateReason; // what the printer says of its state, or empty
    bool acceptsJobs = true;
    bool printsColour = true;
    // What the printer does to a page's size where it is told nothing of that, in IPP's words
    // ("none", "fit" …); empty where it does not say.
    QString scaling;
    bool takesTrueSize = false; // past its queue: a PDF that says that it is not to be scaled
    bool answers = true; // the printer itself and not only its queue, as far as it can be asked
    // Whether a job counts as printed by the printer's own word. Else by that of its queue, which
    // only knows that the job was sent.
    bool tellsPrinted = true;
    std::vector<PrinterMedia> media;
};

// One job: pages of one size, as a PDF and as what paints them, whichever the system takes. Both
// show the same, scales corrected.
struct PrintTask {
    QString printer;
    QString title;
    PrinterMedia media;
    QByteArray pdf;
    int pages = 1;                             // copies included
    std::function<void(QPainter&, int)> paint; // a page, with a painter in mm
    // To the printer itself: its queue does not pass on that the pages are not to be scaled.
    bool pastQueue = false;
};

struct PrintJob {
    QString printer;
    int id = 0;             // the queue's number of it …
    bool pastQueue = false; // … or the printer's own
};

enum class JobState { Waiting, Held, Printing, Stopped, Printed, HandedOver, Cancelled, Failed };

struct JobStatus {
    JobState state = JobState::Waiting;
    QString reason; // in the system's words, or empty
};

// Calls may take as long as the printer takes to answer; use one object from one thread. Members
// throw Error when the system does not answer.
class PrintSystem {
public:
    virtual ~PrintSystem() = default;

    // Names of the printers, sorted.
    virtual QStringList printers() = 0;
    // Asked of the printer now; none of that name: nothing.
    virtual std::optional<PrinterInfo> printer(const QString& name) = 0;
    // Hands a job over, with its media and without any scaling.
    virtual PrintJob submit(const PrintTask& task) = 0;
    virtual JobStatus status(const PrintJob& job) = 0;
    virtual void cancel(const PrintJob& job) = 0;
};

// The best that this platform has: CUPS, else Qt's. Throws Error where the program was built with
// neither.
std::unique_ptr<PrintSystem> printSystem();

// The portable route through QPrinter: sends paintings instead of PDF and cannot follow a job past
// the system's queue (JobState::HandedOver). Null where the program was built without it.
std::unique_ptr<PrintSystem> qtPrintSystem();
// Null where the program was built without CUPS.
std::unique_ptr<PrintSystem> cupsPrintSystem();

} // namespace dipwright
