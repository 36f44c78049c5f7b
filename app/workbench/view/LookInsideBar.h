// Controls for looking inside: the section plane through body and film, and the opacity of the
// film. Each half can be hidden.
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

    // The section plane: its world axis, its position along the axis (0 … 1), and whether the side
    // after it is drawn.
    int axis() const;
    double share() const;
    bool isAfter() const;
    void setShare(double share);        // and emits sectionChanged()
    void setPlace(const QString& text); // the position as text
    double filmOpacity() const;         // 0 … 1

signals:
    void sectionChanged();
    void filmOpacityChanged();

private:
    QWidget* makeSection();
    QWidget* makeOpacity();
    void showAny();

    QComboBox* axis_;
    QSlider *section_, *opacity_;
    QToolButton* after_;
    QLabel *place_, *percent_;
    QWidget *sectionHalf_, *opacityHalf_;
    bool hasSection_ = false, hasOpacity_ = false;
};

} // namespace dipwright
