#include <stdio.h>

int main(void)
{
	puts("limber");
	return 0;
}
