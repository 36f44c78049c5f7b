// Whether the job of the last run is to be printed, why, where to look first, and a map of how far
// a sheet may be off.
#pragma once

#include "workbench/dip/DipJob.h"
#include "workbench/widgets/Units.h"

#include <QWidget>

class QTextBrowser;
class QUrl;

namespace dipwright {

class PicturePanel;

class CertaintyPanel : public QWidget {
    Q_OBJECT

public:
    explicit CertaintyPanel(QWidget* parent = nullptr);

    // Of an immersion that has an outcome, or of none.
    void setOutcome(const DipOutcome& outcome, std::size_t immersion, LengthUnit unit);

protected:
    void resizeEvent(QResizeEvent* event) override;

signals:
    void placeChosen(Eigen::Vector2f rest); // on the floating film
    void fieldChosen(const QString& path);  // of the project: a limit

private:
    void choosePlace(const QUrl& link);
    void fitText();

    std::vector<UncertainPlace> places_;
    QTextBrowser* text_;
    PicturePanel* map_;
};

} // namespace dipwright
