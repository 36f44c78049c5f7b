// Shows the poses of a path in a list, and the values of the chosen one in fields.
#pragma once

#include "settings/DipPath.h"
#include "workbench/widgets/Units.h"

#include <QWidget>
#include <array>
#include <functional>

class QListWidget;
class QPushButton;

namespace dipwright {

class NumberBox;

class PathKeyFields : public QWidget {
    Q_OBJECT

public:
    explicit PathKeyFields(LengthUnit unit, QWidget* parent = nullptr);

    // `depth`: of the dip, which the poses without a depth of their own have. Emits only chosen(),
    // if the chosen pose no longer exists.
    void show(const std::vector<PathKey>& keys, Millimetres depth);

    void choose(int key);

signals:
    void changed(const std::vector<dipwright::PathKey>& keys);
    void addAsked(int before); // a pose between `before` and the next one
    void removeAsked(int key);
    void chosen(int key); // -1: none
    void left();          // a field lost the focus
    void refused(const QString& sentence);

private:
    // set(pose, value): stores a value in the units of the project file.
    NumberBox* addBox(Unit unit, const QString& name, const QString& text,
                      const std::function<void(PathKey&, double)>& set);
    void showChosen();
    void change(const std::function<void(PathKey&)>& set); // the chosen pose
    QString textOf(std::size_t key) const;

    LengthUnit unit_;
    std::vector<PathKey> keys_;
    Millimetres dipDepth_{0};
    QListWidget* list_;
    QPushButton *add_, *remove_;
    NumberBox *time_, *depth_;
    std::array<NumberBox*, 2> beside_;
    std::array<NumberBox*, 3> turn_;
};

} // namespace dipwright
