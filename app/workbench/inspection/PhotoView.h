// Shows a photo with marked places, which can be clicked and dragged.
#pragma once

#include "workbench/widgets/PictureView.h"

namespace dipwright {

class PhotoView : public PictureView {
    Q_OBJECT

public:
    using PictureView::PictureView;

    // Places are in pixels from the photo's upper left corner.
    void setPhoto(const QImage& photo) { setPicture(photo, photo.size()); }
    void setMarks(const QList<QPointF>& marks);
    void setChosen(int mark);                             // −1: none
    void setPending(const std::optional<QPointF>& place); // a place without a partner
    // Each line runs from the expected place to the place in the photo. If the lines are short, all
    // are drawn enlarged.
    void setResiduals(const QList<QLineF>& residuals);

signals:
    void clicked(QPointF place);
    void markChosen(int mark);
    void markDragged(int mark, QPointF place);
    void markDropped();
    void removeAsked(int mark);

protected:
    void paintOver(QPainter& painter) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    int markNear(QPointF inWidget) const; // −1: none
    double enlargement() const;           // factor for the residuals

    QList<QPointF> marks_;
    QList<QLineF> residuals_;
    std::optional<QPointF> pending_;
    int chosen_ = -1;
    int dragged_ = -1;
    QPointF pressed_;
};

} // namespace dipwright
