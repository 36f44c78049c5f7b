// Controls for looking inside: the section plane through body and film, and the opacity of the
// film. Section controls and opacity control can be hidden separately.
#pragma once

#include <QWidget>

class QComboBox;
class QLabel;
class QSlider;
class QToolButton;

namespace dipwright {

class LookInsideBar : public QWidget {
    Q_OBJECT

public:
    explicit LookInsideBar(QWidget* parent = nullptr);

    void setSectionShown(bool shown);
    void setOpacityShown(bool shown);

    int axis() const;                   // world axis that the section plane is perpendicular to
    double share() const;               // position of the section plane along the axis, 0 … 1
    bool isFarSideShown() const;        // whether the side beyond the section plane is drawn
    void setShare(double share);        // also emits sectionChanged()
    void setPlace(const QString& text); // the position as text
    double filmOpacity() const;         // 0 … 1

signals:
    void sectionChanged();
    void filmOpacityChanged();

private:
    QWidget* makeSection();
    QWidget* makeOpacity();
    void updateVisibility();

    QComboBox* axis_;
    QSlider *section_, *opacity_;
    QToolButton* after_;
    QLabel *place_, *percent_;
    QWidget *sectionHalf_, *opacityHalf_;
    bool hasSection_ = false, hasOpacity_ = false;
};

} // namespace dipwright
