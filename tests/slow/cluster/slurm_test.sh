#!/bin/bash
# Slurm must behave as these tests assume.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/slurm.sh"
source "${0%/*}/../../pipeline/support.sh"

test_runs_a_step_and_passes_its_exit_code() {
  expect_line "$(srun --nodes=1 --ntasks=1 env)" '^SLURMD_NODENAME=n1$'
  expect_exit 65 srun --quiet --nodes=1 --ntasks=1 bash -c 'exit 65'
}

test_nobody_else_reaches_it() {
  expect_equal "$(tail -n +2 /proc/net/dev | awk 'NR > 1 { print $1 }' | xargs)" "lo:"
}

test_runs_a_job_requeues_it_and_reports_its_end() {
  printf '#!/bin/bash\necho began >>lives\nsleep 30\n' >job
  local job
  job=$(sbatch --parsable --output=/dev/null job)
  wait_for_job RUNNING "$job"
  wait_for lives
  scontrol requeue "$job"
  wait_for_job PENDING "$job"
  begin_again "$job"
  wait_for_job RUNNING "$job"
  expect_equal "$(sort -u lives)" began
  scancel "$job"
  wait_for_job CANCELLED "$job"
}

# Slurm of Debian 12 returns 0, which is why step.sh checks a step's outputs; that of Debian 13 returns 1.
test_srun_may_say_0_when_its_node_is_lost() {
  expect_exit $(($(slurm_release) < 23 ? 0 : 1)) lose_a_node
  start_node n2
  wait_for_nodes
}

lose_a_node() {
  srun --quiet --nodes=1 --ntasks=1 --nodelist=n2 sleep 60 &
  wait_for_job RUNNING
  sleep 1
  lose_node n2
  wait $!
}

test_continues_after_slurmctld_was_killed() {
  srun --quiet --nodes=1 --ntasks=1 bash -c 'sleep 6; echo here' >output &
  wait_for_job RUNNING
  sleep 4
  restart_ctld
  expect_exit 0 wait $!
  expect_equal "$(<output)" here
}

slurm_up
run_tests "$@"
