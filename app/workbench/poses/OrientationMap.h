// How good every side of the body is to go down first, as a map of all directions.
#pragma once

#include "search/PoseSearch.h"

#include <QImage>
#include <QWidget>

namespace dipwright {

// The sphere of directions on a disc, equal areas equally large: the body as its file has it goes
// down in the middle, upside down all along the rim, its right side to the right and its front
// below. Each place has the colour of the nearest direction that was dipped.
class OrientationMap : public QWidget {
    Q_OBJECT

public:
    explicit OrientationMap(QWidget* parent = nullptr);

    void setDirections(std::vector<TriedDirection> directions);
    // Of the poses chosen in the table: rings on the map.
    void setChosen(std::vector<Eigen::Vector3d> downs);

    QSize sizeHint() const override { return {200, 200}; }
    QSize minimumSizeHint() const override { return {140, 140}; }
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override { return width; }

signals:
    void picked(const Eigen::Vector3d& down); // the nearest direction that was dipped

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    bool event(QEvent* event) override; // tells of what is under the cursor

private:
    double radius() const;
    QPointF placeOf(const Eigen::Vector3d& down) const;
    std::optional<Eigen::Vector3d> directionAt(QPointF place) const;  // none off the disc
    const TriedDirection* nearest(const Eigen::Vector3d& down) const; // null: none was dipped
    void draw();

    std::vector<TriedDirection> directions_; // those that were dipped
    double lowest_ = 0, highest_ = 1;        // of their objectives
    std::vector<Eigen::Vector3d> chosen_;
    QImage picture_;
};

} // namespace dipwright
