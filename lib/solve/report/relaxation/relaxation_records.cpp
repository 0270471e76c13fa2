#include "solve/report/relaxation/relaxation_records.h"

#include <cctype>
#include <string>

namespace obby::solve {

void fillRelaxations(schema::Result::Builder record, const std::vector<Relaxation>& found) {
  auto relaxations = record.initRelaxations(uint32_t(found.size()));
  for (uint32_t i = 0; i < relaxations.size(); ++i) {
    relaxations[i].setKind(found[i].kind);
    relaxations[i].setAmount(float(found[i].amount));
    relaxations[i].setPart(found[i].part);
    relaxations[i].setAvoid(found[i].avoid);
    relaxations[i].setField(found[i].field);
    relaxations[i].setSteps(found[i].steps);
    relaxations[i].setText(found[i].text);
  }
  std::string advice = found.empty() ? "no single change that was tried makes the query solvable"
                                     : found.front().text;
  advice.front() = char(std::toupper(advice.front()));
  record.setReason(record.getReason().cStr() + (" " + advice) + ".");
}

}  // namespace obby::solve
