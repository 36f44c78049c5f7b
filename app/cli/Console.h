// Writes results to standard output, and progress and errors to standard error.
#pragma once

#include "base/Error.h"
#include "base/Progress.h"
#include "cli/PlainOutput.h"

#include <QElapsedTimer>
#include <QTextStream>

#include <functional>

namespace dipwright::cli {

class Console {
public:
    Console();

    // Returns the progress of the whole command. It is shown as a bar on a terminal, as plain lines
    // elsewhere, and not at all with --quiet. SIGINT and SIGTERM cancel the command.
    Progress progress();
    void setQuiet(bool quiet) { quiet_ = quiet; }

    QTextStream& out() { return out_; }
    // Prints "error: <what> (<where>)" on one line.
    void error(const Error& error);
    // Returns a function that prints "warning: <what> (<where>)" on one line of standard error.
    std::function<void(const Error&)> warnings();
    // Returns false if standard output did not accept all text (full disk, closed pipe).
    bool finish();

private:
    void report(double share, const QString& text);
    void drawBar(double share, const QString& text);
    void clearBar();
    void printLine(const QString& kind, const Error& error);

    PlainOutput plainOut_, plainErr_;
    QTextStream out_;
    QTextStream err_;
    CancelToken cancelToken_;
    bool quiet_ = false;
    bool terminal_ = false;
    bool barShown_ = false;
    int linePercent_ = -1;
    QString lineText_;
    QElapsedTimer sinceDrawn_;
};

} // namespace dipwright::cli
