// Shows the cost of an order: rows for a table, sentences, CSV and JSON.
#pragma once

#include "cost/OrderCost.h"

#include <QJsonObject>
#include <QStringList>

namespace dipwright {

// A row of a table, in the user's language and number format.
struct CostRow {
    QString what;   // "Film"
    QString amount; // "1.25 m²"
    QString cost;   // "12.50 EUR", or "no price"
};
// Returns the rows for materials and work, then the sum.
std::vector<CostRow> costRows(const OrderCost& cost);
// Returns the rows for the times: each time, then work and elapsed time.
std::vector<CostRow> timeRows(const OrderCost& cost);

// Returns what is not given, and therefore not in the sum: "no price for the film". Empty if
// everything is given.
QStringList missingPrices(const OrderCost& cost);
QStringList missingTimes(const OrderCost& cost);

// Returns the order in one line: number of parts and sheets, cost, and times.
QString costSentence(const OrderCost& cost);
// Returns a duration with two units at most: "45 s", "12 min", "1 h 20 min".
QString durationText(Seconds time);

QJsonObject costJson(const OrderCost& cost);

// A project's cost for one part and for its order.
struct ProjectCost {
    QString project;
    std::vector<OrderCost> orders;
};
// Returns a CSV table with decimal points and LF line ends: the heading
// project,parts,kind,name,amount,unit,price,cost,currency and one line for each item, time and sum.
QByteArray costCsv(const std::vector<ProjectCost>& projects);

} // namespace dipwright
