#include "solve/query_solver.h"

#include "solve/answer/solve_one.h"
#include "solve/players/solve_players.h"

namespace obby::solve {

Result<QueryAnswer> solveQuery(const LoadedLevel& level, schema::Query::Reader query,
                               const SolverOptions& options, const Machine& machine,
                               const SolverOutput& output) {
  if (level::namesPlayers(query)) return solveForPlayers(level, query, options, machine, output);
  return solveFor({level, query, {}}, options, machine, output);
}

}  // namespace obby::solve
