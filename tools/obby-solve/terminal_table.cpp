#include "terminal_table.h"

#include "table/answer_table.h"

namespace obby::tools {

std::optional<TerminalTable> TerminalTable::wanted(const cli::Context& context) {
  if (!context.showsTable()) return {};
  return TerminalTable();
}

io::StreamWriter TerminalTable::writer() const {
  return io::StreamWriter::toFunction(
      [gathering = gathering_](schema::Record::Reader record) -> Status {
        gathering->add(record);
        return {};
      });
}

Status TerminalTable::print(cli::Context& context) const {
  const std::string text =
      table::answerTable(gathering_->answers(), table::terminalTraits(context.colorOutput()));
  return text.empty() ? Status() : context.show(text);
}

}  // namespace obby::tools
