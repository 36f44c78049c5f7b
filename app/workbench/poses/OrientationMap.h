// A map that shows, for each side of the body that could go down first, the objective of such a
// dip.
#pragma once

#include "search/PoseSearch.h"

#include <QImage>
#include <QWidget>

namespace dipwright {

// An equal-area map of the sphere of directions on a disc. The centre stands for the body's
// orientation in its file, the rim for the body upside down. Directions to the body's right are on
// the right, and directions to its front are below. Each place has the colour of the nearest
// simulated direction.
class OrientationMap : public QWidget {
    Q_OBJECT

public:
    explicit OrientationMap(QWidget* parent = nullptr);

    void setDirections(std::vector<TriedDirection> directions);
    // Marks the poses selected in the table with rings.
    void setChosen(std::vector<Eigen::Vector3d> downs);

    QSize sizeHint() const override { return {200, 200}; }
    QSize minimumSizeHint() const override { return {140, 140}; }
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override { return width; }

signals:
    void picked(const Eigen::Vector3d& down); // the nearest simulated direction

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    bool event(QEvent* event) override; // shows tooltips

private:
    double radius() const;
    QPointF placeOf(const Eigen::Vector3d& down) const;
    std::optional<Eigen::Vector3d> directionAt(QPointF place) const;  // none outside the disc
    const TriedDirection* nearest(const Eigen::Vector3d& down) const; // null: none was simulated
    void draw();

    std::vector<TriedDirection> directions_; // the simulated ones
    double lowest_ = 0, highest_ = 1;        // the range of the objectives of directions_
    std::vector<Eigen::Vector3d> chosen_;
    QImage picture_;
};

} // namespace dipwright
