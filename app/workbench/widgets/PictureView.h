// Shows a picture of known size in millimetres. The user can zoom and move it, and read what is
// under the cursor.
#pragma once

#include <QImage>
#include <QLineF>
#include <QWidget>
#include <optional>

class QPainter;

namespace dipwright {

class PictureView : public QWidget {
    Q_OBJECT

public:
    explicit PictureView(QWidget* parent = nullptr);

    // Keeps zoom and place if the size stays the same.
    void setPicture(const QImage& picture, QSizeF millimetres);
    void clear(const QString& hint); // `hint` tells how to get a picture
    bool isEmpty() const { return picture_.isNull(); }
    const QImage& picture() const { return picture_; }

    // Sets lines to draw over the picture, in mm from its upper left corner.
    void setLines(const QList<QLineF>& lines);
    // Marks the place that is under the cursor in another view, in mm from the picture's upper left
    // corner.
    void setCursorAt(const std::optional<QPointF>& place);

    void zoomToFit();
    void zoomToTrueSize(); // 1 mm of the picture is 1 mm on the screen
    void zoomBy(double factor, const std::optional<QPointF>& fixed = {});
    double zoom() const { return pixelsPerMillimetre_; }

    QSize sizeHint() const override { return {360, 420}; }
    QSize minimumSizeHint() const override { return {160, 160}; }

signals:
    void hovered(QPointF millimetres); // inside the picture
    void hoverLeft();
    void zoomChanged();

protected:
    // Draws over the picture, in the widget's coordinates.
    virtual void paintOver(QPainter&) {}
    QPointF pictureAt(QPointF inWidget) const; // in the picture's millimetres
    QPointF widgetAt(QPointF millimetres) const;
    bool contains(QPointF millimetres) const;

    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    QRectF shownRect() const; // the whole picture in the widget
    void fitNow();

    // The picture reduced to a smaller size by averaging.
    const QImage& shrunk(QSize pixels);

    QImage picture_;
    QImage shrunk_;
    QSizeF size_;
    QString hint_;
    QList<QLineF> lines_;
    std::optional<QPointF> cursor_;
    double pixelsPerMillimetre_ = 1;
    QPointF middle_; // centre of the view, in millimetres of the picture
    bool fits_ = true;
    QPointF dragged_;
};

} // namespace dipwright
