// The page of a dipped part: its photos, the places in them, and the error of the image.
#pragma once

#include "workbench/inspection/MeasuredPart.h"
#include "workbench/inspection/PhotoView.h"

#include <QWidget>

class QAction;
class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace dipwright {

class PartPage : public QWidget {
    Q_OBJECT

public:
    explicit PartPage(QWidget* parent = nullptr);

    // Shows the project's photos and pairs. Keeps the shown photo if it still exists.
    void setPart(const InspectedPart& part);
    int photo() const { return photo_; } // the shown photo; −1: none
    // Sets the picture of the shown photo. If the picture is null, shows `hint` instead.
    void setPicture(const QImage& picture, const QString& hint);
    // The place in the photo that waits for its partner on the body.
    std::optional<QPointF> pending() const { return pending_; }
    void setPending(const std::optional<QPointF>& place);
    // Shows the measurement; null: none, or the pairs have changed since.
    void setMeasured(std::shared_ptr<const MeasuredPart> measured);
    void setBusy(bool busy);

signals:
    void photosChosen(const QStringList& files);
    void removePhotoAsked(int photo);
    void photoLookedAt(int photo);
    void pairMoved(int pair, QPointF pixel); // `pair`: index in the project
    void pairDropped();
    void pairChosen(int pair);
    void removePairAsked(int pair);
    void chessboardChosen(bool chessboard);
    void keepsCameraChosen(bool keeps);
    void cameraAsked();
    void cornersAsked();
    void exportAsked();

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    QWidget* makePhotoBar();
    QWidget* makeMeasureBar();
    void lookAt(int photo);
    void showMarks();
    void showFigures();
    void enable();
    void say();

    InspectedPart part_;
    int photo_ = -1;
    bool busy_ = false;
    std::vector<int> shown_; // for each mark, the pair's index in the project
    std::optional<QPointF> pending_;
    std::shared_ptr<const MeasuredPart> measured_;
    QComboBox* photos_;
    PhotoView* view_;
    QLabel* hint_;
    QCheckBox *chessboard_, *keepsCamera_;
    QPushButton *removePhoto_, *removePair_, *camera_, *corners_, *export_;
    QTableWidget* figures_;
    int chosen_ = -1; // the chosen pair's index in the project; −1: none
};

} // namespace dipwright
