// Makes outputs, exports results, sheets, stretch maps and numerical error to files, and prints
// sheets.
#pragma once

#include "pipeline/SheetNumericalError.h"
#include "workbench/dip/DipSession.h"
#include "workbench/document/Preferences.h"
#include "workbench/jobs/Messages.h"

class QWidget;

namespace dipwright {

class StretchPanel;
class WindowActions;

class ExportController : public QObject {
    Q_OBJECT

public:
    // `stretch` requests the export of its map, and gives the map as shown.
    ExportController(const WindowActions& actions, const StretchPanel& stretch,
                     const DipSession& session, JobRunner& jobs, Messages& messages,
                     QWidget& window);

    void showNumericalError(const std::vector<DipNumericalError>& numericalError, bool outdated,
                            LengthUnit unit);
    void setPreferences(const Preferences& preferences) { unit_ = preferences.unit; }
    // Asks for a file name and writes the costs of the shown result as CSV.
    void exportCosts();

private:
    using Write = std::function<void(const QString& path)>;
    void exportResults();
    void exportSheetPdf();
    void exportSheetPng();
    void exportCradles();
    void exportStretch(const QString& suffix); // png, csv or vtp
    void makeOutputs();
    void print();
    void showPlates();
    QString sheetName() const;
    // Asks for a file name and writes the file.
    void exportFile(const QString& title, const QString& name, const QString& suffix,
                    const Write& write);
    Write stretchWriter(const QString& suffix) const;

    const StretchPanel& stretch_;
    const DipSession& session_;
    JobRunner& jobs_;
    Messages& messages_;
    QWidget& window_;
    LengthUnit unit_ = LengthUnit::Millimetre;
};

} // namespace dipwright
