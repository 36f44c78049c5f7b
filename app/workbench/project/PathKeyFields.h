// Shows the poses of a path in a list, and the values of the chosen one in fields.
#pragma once

#include "settings/DipPath.h"
#include "workbench/widgets/Units.h"

#include <QWidget>
#include <array>

class QListWidget;
class QPushButton;

namespace dipwright {

class NumberBox;

class PathKeyFields : public QWidget {
    Q_OBJECT

public:
    explicit PathKeyFields(LengthUnit unit, QWidget* parent = nullptr);

    void show(const std::vector<PathKey>& keys); // emits changed() never, chosen() if it must

    void choose(int key);

signals:
    void changed(const std::vector<dipwright::PathKey>& keys);
    void addAsked(int before); // a pose between `before` and the next one
    void chosen(int key);      // -1: none
    void left();               // a field lost the focus
    void refused(const QString& sentence);

private:
    NumberBox* addBox(Unit unit, const QString& name, const QString& text);
    void showChosen();
    void readFields();
    QString textOf(std::size_t key) const;

    LengthUnit unit_;
    std::vector<PathKey> keys_;
    QListWidget* list_;
    QPushButton *add_, *remove_;
    NumberBox *time_, *depth_;
    std::array<NumberBox*, 2> beside_;
    std::array<NumberBox*, 3> turn_;
};

} // namespace dipwright
