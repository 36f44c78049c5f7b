#include "cli/Console.h"

#include "cli/Terminal.h"

#include <QIODevice>
#include <algorithm>

namespace dipwright::cli {
namespace {

constexpr int barWidth = 30;
constexpr int barInterval = 50;  // ms between two updates
constexpr int linePercents = 10; // %, progress between two plain lines of a task
constexpr int textWidth = 44;

} // namespace

Console::Console()
    : plainOut_(stdout), plainErr_(stderr), out_(&plainOut_), err_(&plainErr_),
      terminal_(standardErrorIsTerminal()) {
    cancelOnSignals(cancelToken_);
}

Progress Console::progress() {
    Progress progress{nullptr, cancelToken_};
    if (!quiet_) {
        progress.report = [this](double share, const QString& text) { report(share, text); };
    }
    return progress;
}

void Console::report(double share, const QString& text) {
    if (terminal_) {
        drawBar(share, text);
        return;
    }
    const int percent = int(share * 100) / linePercents * linePercents;
    if (percent != linePercent_ || text != lineText_) {
        linePercent_ = percent;
        lineText_ = text;
        err_ << QStringLiteral("%1 %  %2\n").arg(int(share * 100), 3).arg(text) << Qt::flush;
    }
}

void Console::drawBar(double share, const QString& text) {
    const bool newWork = text != lineText_;
    if (sinceDrawn_.isValid() && !newWork && sinceDrawn_.elapsed() < barInterval) {
        return;
    }
    sinceDrawn_.start();
    lineText_ = text;
    const int filled = std::clamp(int(share * barWidth), 0, barWidth);
    err_ << "\r[" << QString(filled, QLatin1Char('#'))
         << QString(barWidth - filled, QLatin1Char('.'))
         << QStringLiteral("] %1 %  %2")
                .arg(int(share * 100), 3)
                .arg(text.left(textWidth), -textWidth)
         << Qt::flush;
    barShown_ = true;
}

void Console::clearBar() {
    if (barShown_) {
        err_ << '\r' << QString(barWidth + textWidth + 10, QLatin1Char(' ')) << '\r' << Qt::flush;
        barShown_ = false;
    }
}

void Console::printLine(const QString& kind, const Error& error) {
    clearBar();
    err_ << kind << ": " << error.sentence().simplified() << '\n' << Qt::flush;
}

void Console::error(const Error& error) {
    printLine(QStringLiteral("error"), error);
}

std::function<void(const Error&)> Console::warnings() {
    return [this](const Error& error) { printLine(QStringLiteral("warning"), error); };
}

bool Console::finish() {
    clearBar();
    out_.flush();
    return out_.status() == QTextStream::Ok;
}

} // namespace dipwright::cli
