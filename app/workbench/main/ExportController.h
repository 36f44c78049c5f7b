// What leaves the program: results, sheets, stretch and certainty as files, and sheets on paper.
#pragma once

#include "document/Preferences.h"
#include "pipeline/SheetCertainty.h"
#include "session/DipSession.h"
#include "session/Messages.h"

class QWidget;

namespace dipwright {

class StretchPanel;
class WindowActions;

class ExportController : public QObject {
    Q_OBJECT

public:
    ExportController(const WindowActions& actions, const DipSession& session, JobRunner& jobs,
                     Messages& messages, QWidget& window);

    void exportStretch(const StretchPanel& stretch, const QString& suffix); // png, csv or vtp
    void showCertainty(const std::vector<ImmersionCertainty>& certainty, bool outdated,
                       LengthUnit unit);

private:
    using Write = std::function<void(const QString& path)>;
    void exportResults();
    void exportSheetPdf();
    void exportSheetPng();
    void print();
    QString sheetName() const;
    // Asks for a file and has it written.
    void exportFile(const QString& title, const QString& name, const QString& suffix,
                    const Write& write);
    Write stretchWriter(const StretchPanel& stretch, const QString& suffix) const;

    const DipSession& session_;
    JobRunner& jobs_;
    Messages& messages_;
    QWidget& window_;
};

} // namespace dipwright
