// How deep the view looks inside: where a plane cuts body and film open, and how much is seen
// through the film. Each half is shown when it is wanted.
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

    // The plane: across which axis of the world, how far along what is to be cut (0 … 1), and
    // whether what lies after it is left.
    int axis() const;
    double share() const;
    bool isAfter() const;
    void setShare(double share);        // and tells
    void setPlace(const QString& text); // where that is, for the user
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
